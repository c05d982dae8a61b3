#pragma once

#include <span>

#include "sim/elasticity/element.h"
#include "sim/mesh/tet_mesh.h"

namespace griffith {

/// A tet's values out of values per node of the mesh.
inline Corners corners_of(const TetMesh& mesh, TetId tet, std::span<const Vec3> values) {
  Corners corners;
  for (int i = 0; i < 4; ++i) corners.col(i) = values[mesh.tets[tet][i]];
  return corners;
}

}  // namespace griffith
