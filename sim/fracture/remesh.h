#pragma once

#include <cstdint>
#include <span>

#include "sim/mesh/bisect.h"

namespace griffith {

/// How closely a crack follows its plane, and what stops it from cutting tets.
struct RemeshOptions {
  BisectionLimits limits{.min_length = 0, .min_quality = 0.1};
  double snap_fraction = 0.2;  ///< a node counts as on the plane when that cuts an edge this near to it, 0..0.5
  double snap_angle = 0.1;     ///< or when the line to it from the separating node is this close to the plane [rad]
  double crack_angle = 0.8;    ///< or this close, and an existing crack's: no second crack runs beside it [rad]
};

/// A node's star, cut along a plane.
struct StarCut {
  Subdivision subdivision;          ///< nodes and tets that were made
  std::vector<std::uint8_t> above;  ///< per tet of the star as it is now: 1 above the plane, 0 below, for split_node()
  int refused_edges = 0;            ///< that the plane crosses, but that would have made tets below the limits
};

/// Cuts the tets of a node's star along the plane through its position with unit normal `normal`, so that split_node()
/// opens the mesh there (O'Brien & Hodgins 1999, §5): edges opposite the node are bisected where they cross the plane,
/// with all tets round them, so that the mesh goes on conforming. Nodes near the plane and surfaces nearly along it (a
/// crack's, above all) are taken for parts of it, and where an edge must not be bisected its nearer end is: there the
/// crack follows existing faces. What bisect_edge() says of momentum and energy holds.
///
/// `positions`, `at_crack_front` (1 where cut faces end): per node.
StarCut cut_star(TetMesh& mesh, std::span<const Vec3> positions, std::span<const std::uint8_t> at_crack_front,
                 NodeId node, const Vec3& normal, const RemeshOptions& options);

}  // namespace griffith
