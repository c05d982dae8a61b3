#pragma once

#include <array>
#include <functional>
#include <span>
#include <utility>
#include <vector>

#include "sim/elasticity/element.h"
#include "sim/elasticity/tangent_stiffness.h"
#include "sim/mesh/tet_edges.h"
#include "sim/mesh/tet_mesh.h"
#include "sim/solver/block_sparse_matrix.h"

namespace griffith {

/// Factors of mass and stiffness in a system matrix: mass · M + stiffness · K.
struct MatrixFactors {
  double mass = 1;
  double stiffness = 1;

  bool operator==(const MatrixFactors&) const = default;
};

/// Columns of the nodes and edges of a mesh, -1 for none.
struct QuadraticColumns {
  std::function<int(NodeId)> of_node;
  std::function<int(EdgeId)> of_edge;
};

/// Rows of mass · M + stiffness · K, one a node, and what they are assembled from: the tets of the node's star.
/// Quadratic bodies have rows of edges after those of nodes.
struct ElementRows {
  struct TetAtNode {
    TetId tet;
    int corner;                ///< which of the tet's corners the node is; of an edge's row: 4 + which of its edges
    std::array<int, 4> slots;  ///< per corner of the tet: which of the row's blocks, -1 where it has no column
  };
  std::vector<NodeId> nodes;                   ///< per row
  std::vector<EdgeId> edges;                   ///< per row after those
  std::vector<std::array<int, 6>> edge_slots;  ///< per entry of `tets`, as its slots; empty without edges
  BlockSparseMatrix matrix;
  std::vector<int> tet_starts = {0};  ///< rows + 1, into `tets`
  std::vector<TetAtNode> tets;

  /// Appends the row of a node. `column_of_node`: per node of the mesh, -1 for none; empty: each node is a column. The
  /// blocks are left for allocate().
  void add(const TetMesh& mesh, NodeId node, std::span<const int> column_of_node);
  /// Appends the row of a node, or, after all nodes, of an edge, of a quadratic body.
  void add_quadratic(const TetMesh& mesh, const TetEdges& topology, NodeId node, const QuadraticColumns& columns);
  void add_quadratic(const TetMesh& mesh, const TetEdges& topology, EdgeId edge, const QuadraticColumns& columns);
  /// Makes room for the blocks of all rows.
  void allocate() { matrix.blocks.resize(matrix.columns.size()); }
  /// Fits the rows to a topology in which nodes have only lost tets, or have received them from one that did.
  /// `node_list`: the present nodes, `column_of_node` their rows. Rows with the same tets and neighbors are moved, all
  /// others are rebuilt; the blocks are left to assemble(). The columns must be the rows' own nodes. Returns the
  /// previous row of each node, -1 for a new one.
  std::vector<int> patch(const TetMesh& mesh, std::span<const NodeId> node_list, std::span<const int> column_of_node);
  /// Returns its approximate memory [bytes].
  std::size_t memory() const {
    return edge_slots.size() * sizeof(edge_slots[0]) + matrix.blocks.size() * (sizeof(Mat3) + sizeof(int)) +
           tets.size() * sizeof(TetAtNode) + nodes.size() * 4 * sizeof(int);
  }
  /// Computes all blocks for the present states, of quadratic tets the mean ones. Spans are per node, tet or edge of
  /// the mesh; the diagonal block of row i is in the column of node i.
  void assemble(const MatrixFactors& factors, const ElasticLaw& law, std::span<const RestElement> rest_elements,
                std::span<const ElementState> states, std::span<const double> masses,
                std::span<const double> edge_masses = {});

  /// Does the same for a linear body, with the second derivatives of its energy, per tet of the mesh.
  void assemble(const MatrixFactors& factors, std::span<const RestElement> rest_elements,
                std::span<const TangentStiffness> tangents, std::span<const double> masses);

 private:
  template <class RowOf>
  void assemble_rows(double of_mass, std::span<const double> masses, const RowOf& row_of);
  void add_quadratic_row(const TetMesh& mesh, const TetEdges& topology, std::span<const std::pair<TetId, int>> star,
                         const QuadraticColumns& columns);
  void assemble_quadratic(const MatrixFactors& factors, const ElasticLaw& law,
                          std::span<const RestElement> rest_elements, std::span<const ElementState> states,
                          std::span<const double> masses, std::span<const double> edge_masses);
  /// Appends a row of other ElementRows, with the same tets and neighbors.
  void keep(const ElementRows& from, int row, std::span<const int> column_of_node);
};

}  // namespace griffith
