#pragma once

#include <span>
#include <vector>

#include "sim/explicit/microstep_contacts.h"
#include "sim/fracture/cohesion.h"

namespace griffith {

struct WorldState;

/// Cracks of microsteps by the faces of tets that are their sides.
class CracksByFace {
 public:
  /// `slots`: number of tet slots of the explicit bodies.
  explicit CracksByFace(std::size_t slots = 0) : crack_of_face_(4 * slots, -1) {}

  /// Takes a crack of the microsteps' contacts.
  void add(const explicit_dynamics::MicrostepContacts& contacts, int crack);
  /// Bonds a corner of an open face, whose first tet has this slot. A slit that was in the mesh from the start is no
  /// crack and holds nothing.
  void bond(explicit_dynamics::MicrostepContacts& contacts, const OpenFace& face, int first_slot, int corner,
            const Bond& bond) const;

 private:
  std::vector<int> crack_of_face_;  ///< per 4·slot + face; -1: none
};

/// Bonds the cracks of microsteps as the world's cohesive faces are. What has opened since is broken so far, for
/// nothing. `slot_of_tet`: -1 for tets outside the microsteps.
void restore_bonds(const WorldState& world, std::span<const int> slot_of_tet,
                   const explicit_dynamics::ExplicitBodies& bodies, const CracksByFace& cracks,
                   explicit_dynamics::MicrostepContacts& contacts);

}  // namespace griffith
