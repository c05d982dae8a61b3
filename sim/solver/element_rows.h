#pragma once

#include <array>
#include <span>
#include <vector>

#include "sim/elasticity/element.h"
#include "sim/mesh/tet_mesh.h"
#include "sim/solver/block_sparse_matrix.h"

namespace griffith {

/// What scales mass and stiffness in a system matrix: mass · M + stiffness · K.
struct MatrixFactors {
  double mass = 1;
  double stiffness = 1;

  bool operator==(const MatrixFactors&) const = default;
};

/// Rows of mass · M + stiffness · K, one a node, and what they are assembled from: the tets of the node's star.
struct ElementRows {
  struct TetAtNode {
    TetId tet;
    int corner;                ///< which of the tet's corners the node is
    std::array<int, 4> slots;  ///< per corner of the tet: which of the row's blocks, -1 where it has no column
  };
  std::vector<NodeId> nodes;  ///< per row
  BlockSparseMatrix matrix;
  std::vector<int> tet_starts = {0};  ///< rows + 1, into `tets`
  std::vector<TetAtNode> tets;

  /// Appends the row of a node. `column_of_node`: per node of the mesh, -1 for none; empty: each node is a column. The
  /// blocks are left for allocate().
  void add(const TetMesh& mesh, NodeId node, std::span<const int> column_of_node);
  /// Makes room for the blocks of all rows.
  void allocate() { matrix.blocks.resize(matrix.columns.size()); }
  /// Fits the rows to a topology in which stars have only lost tets, or got them from one that did: `node_list` are the
  /// nodes now, `column_of_node` their rows. Rows whose star and neighbours stand are moved, all others made anew; the
  /// blocks are left for assemble(). The columns must be the rows' own nodes. Returns the row that each node had, -1
  /// for a new one.
  std::vector<int> patch(const TetMesh& mesh, std::span<const NodeId> node_list, std::span<const int> column_of_node);
  /// About [bytes].
  std::size_t memory() const {
    return matrix.blocks.size() * (sizeof(Mat3) + sizeof(int)) + tets.size() * sizeof(TetAtNode) +
           nodes.size() * 4 * sizeof(int);
  }
  /// Computes all blocks for the present states. Spans are per node or tet of the mesh; the diagonal block of row i
  /// is in the column of node i.
  void assemble(const MatrixFactors& factors, const ElasticLaw& law, std::span<const RestElement> rest_elements,
                std::span<const ElementState> states, std::span<const double> masses);

 private:
  /// Appends a row of other ElementRows whose star and neighbours stand.
  void keep(const ElementRows& from, int row, std::span<const int> column_of_node);
};

}  // namespace griffith
