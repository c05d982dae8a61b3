#pragma once

#include <array>
#include <vector>

#include "sim/core/ids.h"
#include "sim/core/linear_algebra.h"

namespace griffith {

/// Tetrahedra as read or generated, before anything is known of their neighbours.
struct TetSoup {
  std::vector<Vec3> points;              ///< [m]
  std::vector<std::array<int, 4>> tets;  ///< indices into `points`
};

/// The four faces of a tet: face i lies opposite corner i, its corners counter-clockwise seen from outside.
inline constexpr std::array<std::array<int, 3>, 4> kTetFaces = {{{1, 2, 3}, {0, 3, 2}, {0, 1, 3}, {0, 2, 1}}};

/// A tetrahedral mesh with its topology. All bodies of a world live in one mesh; cracks cut neighbour links and append
/// nodes, and where bodies are remeshed (bisect.h) they append tets. None is ever removed. Tets are positively
/// oriented: det(x1−x0, x2−x0, x3−x0) > 0 in rest space.
struct TetMesh {
  std::vector<Vec3> rest_positions;              ///< per node [m]
  std::vector<std::array<NodeId, 4>> tets;       ///< per tet: its corners
  std::vector<std::array<TetId, 4>> neighbours;  ///< per tet: the tet behind face i, or an invalid id
  std::vector<std::vector<TetId>> stars;         ///< per node: its tets, ascending

  int node_count() const { return static_cast<int>(rest_positions.size()); }
  int tet_count() const { return static_cast<int>(tets.size()); }
};

}  // namespace griffith
