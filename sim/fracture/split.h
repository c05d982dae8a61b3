#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "sim/mesh/tet_mesh.h"

namespace griffith {

/// A node that was parted: `copy` is new and takes over some tets of `original`.
struct NodeCopy {
  NodeId original, copy;
};

/// For each tet of a node's star whether its centroid lies on the side of the plane through the node to which `normal`
/// points (1) or not (0).
std::vector<std::uint8_t> tets_above(const TetMesh& mesh, std::span<const Vec3> positions, NodeId node,
                                     const Vec3& normal);

struct SplitResult {
  std::vector<NodeCopy> copies;
  std::vector<NodeId> front;        ///< nodes of cut faces that still hold both sides together
  std::vector<TetId> changed_tets;  ///< tets that lost a neighbour, ascending
  bool too_small = false;           ///< refused: a fragment of fewer than the wanted tets would have come off
};

/// Opens the mesh at `node` along the plane through its position with unit normal `normal`, without remeshing: faces at
/// the node between tets whose centroids lie on opposite sides are cut, then every touched node is parted into the
/// face-connected components of its star, so that no pieces hang together by a node or an edge alone (re-certification,
/// Parker & O'Brien 2009, made local). The largest component keeps the node. Costs the stars involved, not the mesh.
///
/// Appends to the mesh's nodes (rest positions and stars); the caller extends whatever else it keeps per node. Nothing
/// changes when all tets lie on one side, or when a piece of fewer than `min_fragment_tets` would come off.
SplitResult split_node(TetMesh& mesh, std::span<const Vec3> positions, NodeId node, const Vec3& normal,
                       int min_fragment_tets = 1);

/// Splits between any two sides of the node, as tets_above() gives them.
SplitResult split_node(TetMesh& mesh, NodeId node, std::span<const std::uint8_t> above, int min_fragment_tets = 1);

}  // namespace griffith
