#pragma once

#include <span>

#include "sim/fracture/split.h"
#include "sim/mesh/bisect.h"

namespace griffith {

/// How closely a crack follows its plane, and what stops it from cutting tets.
struct RemeshOptions {
  BisectionLimits limits{.least_length = 0, .least_quality = 0.1};
  double snap_share = 0.2;    ///< a node counts as on the plane when that cuts an edge this near to it, 0..0.5
  double snap_angle = 0.1;    ///< or when the line to it from the separating node is this close to the plane [rad]
  double crack_angle = 0.8;   ///< or this close, and an existing crack's: no second crack runs beside it [rad]
  int min_fragment_tets = 1;  ///< as for split_node()
};

struct RemeshResult {
  Subdivision subdivision;  ///< nodes and tets made by cutting; they stay even when the split does not happen
  SplitResult split;        ///< after that; a copy's original may be one of the new nodes
  int refused_edges = 0;    ///< that the plane crosses, but that would have made tets below the limits
};

/// Opens the mesh at `node` along the plane through its position with unit normal `normal`, cutting the tets of its
/// star which the plane crosses (O'Brien & Hodgins 1999, §5): edges opposite the node are bisected where they cross it,
/// with all tets round them, so that the mesh goes on conforming. Then the faces on the plane are cut and the touched
/// nodes parted as by split_node(). Nodes near the plane and surfaces nearly along it (a crack's, above all) are taken
/// for parts of it, and where an edge must not be bisected its nearer end is: there the crack follows existing faces.
///
/// `positions`, `at_crack_front` (1 where cut faces end): per node. What bisect_edge() says of momentum and energy
/// holds; the split keeps all of it.
RemeshResult remesh_node(TetMesh& mesh, std::span<const Vec3> positions, std::span<const std::uint8_t> at_crack_front,
                         NodeId node, const Vec3& normal, const RemeshOptions& options);

}  // namespace griffith
