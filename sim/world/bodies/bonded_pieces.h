#pragma once

#include <vector>

#include "sim/core/ids.h"
#include "sim/fracture/cohesion.h"

namespace griffith {

struct Body;
struct WorldState;

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

/// Adds an opened face whose bonds hold. Of its area, only the part whose energy they have taken counts as crack area.
void add_cohesive_face(WorldState& world, const CohesiveFace& face);
/// Breaks all bonds of opened faces beside tets for which `is_freed` (per tet) is true.
void free_cohesive_faces(WorldState& world, const std::vector<bool>& is_freed);

}  // namespace griffith
