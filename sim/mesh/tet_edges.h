#pragma once

#include <array>
#include <span>
#include <vector>

#include "sim/core/ids.h"
#include "sim/core/tet_edge_corners.h"
#include "sim/mesh/bisect.h"
#include "sim/mesh/tet_mesh.h"

namespace griffith {

using EdgeId = Id<struct EdgeTag>;

/// Edges of quadratic tets, which have their own displacements (quadratic_element.h). An edge joins two nodes, and
/// cracks separate it with them. Edges are never removed; one that was
/// bisected belongs to no tet.
struct TetEdges {
  std::vector<std::array<NodeId, 2>> ends;    ///< per edge: its nodes, ascending
  std::vector<std::array<EdgeId, 6>> of_tet;  ///< per tet, as kTetEdges; invalid for linear ones; empty: all linear

  int edge_count() const { return static_cast<int>(ends.size()); }
  bool is_quadratic(TetId tet) const { return !of_tet.empty() && of_tet[tet][0].valid(); }
};

/// Numbers the edges of `tets`, which have none yet. O(n log n), deterministic.
void add_edges(const TetMesh& mesh, std::span<const TetId> tets, TetEdges& edges);

/// Returns the edges of `tets`, ascending, without duplicates; none of linear tets.
std::vector<EdgeId> edges_of(const TetEdges& edges, std::span<const TetId> tets);

/// New edge of bisected tets. The quadratic field has Σ weights[i] · value(from[i]) there, of those that are valid.
struct EdgePart {
  EdgeId edge;
  std::array<EdgeId, 3> from;
  std::array<double, 3> weights{};
};

/// Bisected edge of quadratic tets, and the new edges of their halves; none of linear tets.
struct BisectedEdges {
  EdgeId bisected;
  std::vector<EdgePart> parts;
};
/// Gives the halves of quadratic tets their edges, after the new node `middle`. `of_tet` has room for the children.
BisectedEdges bisect_edges(const EdgeNode& middle, std::span<const TetBisection> halves, TetEdges& edges);

/// Separated edge: `copy` is new and replaces `original` in some tets.
struct EdgeCopy {
  EdgeId original, copy;
};

/// Separates edges after nodes were separated. `copied`: the new nodes, whose tets still have the old edges. If all
/// tets of an edge have a copied node, the edge continues between its new ends. If only some have, these get a copy of
/// it.
std::vector<EdgeCopy> part_edges(const TetMesh& mesh, std::span<const NodeId> copied, TetEdges& edges);

}  // namespace griffith
