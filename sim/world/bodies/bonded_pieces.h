#pragma once

#include <cstddef>
#include <vector>

#include "sim/core/ids.h"
#include "sim/fracture/cohesion.h"

namespace griffith {

struct Body;
struct WorldState;

/// Parts of a body that faces connect.
class ConnectedParts {
 public:
  /// The body must outlive this and keep its tets.
  ConnectedParts(const WorldState& world, const Body& body);

  /// Returns the tets of each part, ascending.
  const std::vector<std::vector<TetId>>& tets() const { return tets_; }
  /// Returns the part of a tet of the body.
  int of(TetId tet) const;

 private:
  const Body& body_;
  std::vector<std::vector<TetId>> tets_;
  std::vector<int> part_of_;  ///< in the order of the body's tets
};

/// Pieces of bodies that faces or holding bonds connect.
class BondedPieces {
 public:
  /// The world must outlive this and keep its bonds.
  explicit BondedPieces(const WorldState& world);

  /// Returns the pieces of a body. Each is ascending, and they are in the order of their first tets.
  std::vector<std::vector<TetId>> of(const Body& body) const;

 private:
  const WorldState& world_;
  std::vector<std::vector<const CohesiveFace*>> faces_;  ///< per BodyId; empty without any bonds
};

/// True if bonds alone hold parts of a body together that stays rigid but for microsteps, in which they act.
bool is_held_by_bonds(const WorldState& world, const Body& body);
/// Adds an opened face whose bonds hold or that ends at a front, else does nothing. Of its area, only the part whose
/// energy they have taken counts as crack area.
void add_cohesive_face(WorldState& world, const CohesiveFace& face);
/// Removes an opened face; its index among those of the world.
void remove_cohesive_face(WorldState& world, std::ptrdiff_t index);
/// Opens a bond of an opened face as far as `opening` [m]. Returns the energy that it takes [J].
double open_cohesive_face(WorldState& world, int index, int corner, double opening);
/// True if any bond of an opened face holds.
bool still_holds(const CohesiveFace& face);
/// True if the sides of an opened face have not come apart at a corner.
bool is_at_front(const TetMesh& mesh, const OpenFace& face, int corner);
/// Removes the opened faces that neither hold nor end at a front.
void forget_broken_faces(WorldState& world);
/// Fits the opened faces to cracks and cuts: corners that have come apart without a bond are free.
void follow_front(WorldState& world);
/// Breaks all bonds of opened faces beside tets for which `is_freed` (per tet) is true.
void free_cohesive_faces(WorldState& world, const std::vector<bool>& is_freed);

}  // namespace griffith
