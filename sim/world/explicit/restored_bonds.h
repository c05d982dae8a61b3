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
  CracksByFace() = default;
  /// Takes all cracks of the contacts of explicit bodies with that many tet slots.
  CracksByFace(const explicit_dynamics::MicrostepContacts& contacts, int slots);

  /// Takes a crack of the microsteps' contacts.
  void add(const explicit_dynamics::MicrostepContacts& contacts, int crack);
  /// Bonds a corner of an open face, whose first tet has this slot. A slit that was in the mesh from the start is no
  /// crack and holds nothing.
  void bond(explicit_dynamics::MicrostepContacts& contacts, const OpenFace& face, int first_slot, int corner,
            const Bond& bond) const;

 private:
  std::vector<int> crack_of_face_;  ///< per 4·slot + face; -1: none
};

/// Bonds the cracks of new contacts as the world's cohesive faces are, and ties the edges along them. What has opened
/// since is broken so far, for nothing. `slot_of_tet`: -1 for tets outside the microsteps. Returns the cracks.
CracksByFace restore_bonds(const WorldState& world, std::span<const int> slot_of_tet,
                           explicit_dynamics::ExplicitBodies& bodies, explicit_dynamics::MicrostepContacts& contacts);

}  // namespace griffith
