#pragma once

#include <array>
#include <span>
#include <vector>

#include "sim/core/ids.h"
#include "sim/core/tet_edge_corners.h"
#include "sim/mesh/tet_mesh.h"

namespace griffith {

using EdgeId = Id<struct EdgeTag>;

/// The edges of quadratic tets, which have displacements of their own (quadratic_element.h). One edge joins two nodes:
/// cracks part it with them. None is ever removed.
struct TetEdges {
  std::vector<std::array<NodeId, 2>> ends;    ///< per edge: its nodes, ascending
  std::vector<std::array<EdgeId, 6>> of_tet;  ///< per tet, as kTetEdges; invalid ids in linear ones; empty: all are

  int edge_count() const { return static_cast<int>(ends.size()); }
  bool is_quadratic(TetId tet) const { return !of_tet.empty() && of_tet[tet][0].valid(); }
};

/// Numbers the edges of `tets`, which have none yet. O(n log n), the same for the same mesh.
void add_edges(const TetMesh& mesh, std::span<const TetId> tets, TetEdges& edges);

/// The edges of `tets`, ascending, each once; none of linear tets.
std::vector<EdgeId> edges_of(const TetEdges& edges, std::span<const TetId> tets);

/// An edge that was parted: `copy` is new and takes over some tets of `original`.
struct EdgeCopy {
  EdgeId original, copy;
};

/// Parts edges after nodes were parted: `copied` are the new ones, whose tets still have the edges of before. An edge
/// whose tets have all got a copied node goes on between its new ends; where some have, they get a copy of it.
std::vector<EdgeCopy> part_edges(const TetMesh& mesh, std::span<const NodeId> copied, TetEdges& edges);

}  // namespace griffith
