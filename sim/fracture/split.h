#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "sim/mesh/tet_mesh.h"

namespace griffith {

/// Separated node: `copy` is new and replaces `original` in some tets.
struct NodeCopy {
  NodeId original, copy;
};

/// Returns for each tet of a node's star whether its centroid lies on the side of the plane through the node to which
/// `normal` points (1) or not (0).
std::vector<std::uint8_t> tets_above(const TetMesh& mesh, std::span<const Vec3> positions, NodeId node,
                                     const Vec3& normal);

struct SplitResult {
  std::vector<NodeCopy> copies;
  std::vector<NodeId> front;        ///< nodes of cut faces that still connect both sides
  std::vector<TetId> changed_tets;  ///< tets that lost a neighbor, ascending
  bool too_small = false;           ///< true if refused: a fragment of fewer than the required tets would have come off
};

/// Opens the mesh at `node` along the plane through its position with unit normal `normal`, without remeshing. Cuts
/// faces at the node between tets with centroids on opposite sides. Then separates every affected node into the
/// face-connected components of its star, so that no pieces are connected only by a node or an edge (re-certification,
/// Parker & O'Brien 2009, made local). The largest component keeps the node. The cost depends on the stars involved,
/// not on the mesh.
///
/// Appends to the mesh's nodes (rest positions and stars); the caller extends its own data per node. Nothing changes if
/// all tets lie on one side, or if a piece of fewer than `min_fragment_tets` would come off.
SplitResult split_node(TetMesh& mesh, std::span<const Vec3> positions, NodeId node, const Vec3& normal,
                       int min_fragment_tets = 1);

/// Splits between any two sides of the node, given as by tets_above().
SplitResult split_node(TetMesh& mesh, NodeId node, std::span<const std::uint8_t> above, int min_fragment_tets = 1);

}  // namespace griffith
