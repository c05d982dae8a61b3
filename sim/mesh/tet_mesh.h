#pragma once

#include <array>
#include <vector>

#include "sim/core/ids.h"
#include "sim/core/linear_algebra.h"

namespace griffith {

/// Tetrahedra as read or generated, without topology.
struct TetSoup {
  std::vector<Vec3> points;              ///< [m]
  std::vector<std::array<int, 4>> tets;  ///< indices into `points`
  bool operator==(const TetSoup&) const = default;
};

/// Faces of a tet: face i lies opposite corner i, with its corners counterclockwise seen from outside.
inline constexpr std::array<std::array<int, 3>, 4> kTetFaces = {{{1, 2, 3}, {0, 3, 2}, {0, 1, 3}, {0, 2, 1}}};

/// Tetrahedral mesh with its topology. All bodies of a world share one mesh. Cracks cut neighbor links and append
/// nodes, and remeshing (bisect.h) appends tets. Nothing is ever removed. Tets are positively oriented: det(x1−x0,
/// x2−x0, x3−x0) > 0 in rest space.
struct TetMesh {
  std::vector<Vec3> rest_positions;             ///< per node [m]
  std::vector<std::array<NodeId, 4>> tets;      ///< per tet: its corners
  std::vector<std::array<TetId, 4>> neighbors;  ///< per tet: the tet across face i, or an invalid id
  std::vector<std::vector<TetId>> stars;        ///< per node: its tets, ascending

  int node_count() const { return static_cast<int>(rest_positions.size()); }
  int tet_count() const { return static_cast<int>(tets.size()); }
};

}  // namespace griffith
