#pragma once

#include <cstdint>
#include <span>

#include "sim/mesh/bisect.h"

namespace griffith {

/// Accuracy with which a crack follows its plane, and limits of cutting tets.
struct RemeshOptions {
  BisectionLimits limits{.min_length = 0, .min_quality = 0.1};
  double snap_fraction = 0.2;  ///< a node counts as on the plane if the plane cuts an edge this near to it, 0..0.5
  double snap_angle = 0.1;     ///< or if it is seen from the separating node at most at this angle to the plane [rad]
  double crack_angle = 0.8;    ///< larger angle for nodes of a crack, so that no second one runs beside it [rad]
};

/// Star of a node, cut along a plane.
struct StarCut {
  Subdivision subdivision;          ///< new nodes and tets
  std::vector<std::uint8_t> above;  ///< per tet of the present star: 1 above the plane, 0 below, for split_node()
  int refused_edges = 0;            ///< edges across the plane that were not cut, since tets would be below the limits
};

/// Cuts the tets of a node's star along the plane through its position with unit normal `normal`, so that split_node()
/// opens the mesh there (O'Brien & Hodgins 1999, §5). Edges opposite the node are bisected at the plane, with all tets
/// around them, so that the mesh still conforms. Nodes near the plane and surfaces nearly parallel to it, above all of
/// cracks, count as parts of the plane. If an edge must not be bisected, its nearer end counts as such, and the crack
/// follows existing faces there. Momentum and energy change as in bisect_edge().
///
/// `positions`, `at_crack_front` (1 at the ends of cut faces): per node.
StarCut cut_star(TetMesh& mesh, std::span<const Vec3> positions, std::span<const std::uint8_t> at_crack_front,
                 NodeId node, const Vec3& normal, const RemeshOptions& options);

}  // namespace griffith
