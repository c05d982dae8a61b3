#pragma once

#include <span>

#include "sim/elasticity/element.h"
#include "sim/elasticity/quadratic_element.h"
#include "sim/mesh/tet_edges.h"
#include "sim/mesh/tet_mesh.h"

namespace griffith {

/// Returns a tet's values from values per node of the mesh.
inline Corners corners_of(const TetMesh& mesh, TetId tet, std::span<const Vec3> values) {
  Corners corners;
  for (int i = 0; i < 4; ++i) corners.col(i) = values[mesh.tets[tet][i]];
  return corners;
}

/// Returns a quadratic tet's values from values per edge of the mesh.
inline EdgeVectors edges_of(const TetEdges& topology, TetId tet, std::span<const Vec3> values) {
  EdgeVectors edges;
  for (int i = 0; i < 6; ++i) edges.col(i) = values[topology.of_tet[tet][i]];
  return edges;
}

}  // namespace griffith
