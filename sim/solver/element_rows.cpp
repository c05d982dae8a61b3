#include "sim/solver/element_rows.h"

#include <algorithm>

#include "sim/parallel.h"

namespace griffith {

void ElementRows::add(const TetMesh& mesh, NodeId node, std::span<const int> column_of_node) {
  const std::vector<TetId>& star = mesh.stars[node];
  std::vector<int>& columns = matrix.columns;
  const std::ptrdiff_t first = static_cast<std::ptrdiff_t>(columns.size());
  for (TetId tet : star)
    for (NodeId corner : mesh.tets[tet])
      if (column_of_node[corner] >= 0) columns.push_back(column_of_node[corner]);
  std::sort(columns.begin() + first, columns.end());
  columns.erase(std::unique(columns.begin() + first, columns.end()), columns.end());
  matrix.row_starts.push_back(static_cast<int>(columns.size()));
  matrix.blocks.resize(columns.size());

  const int row = static_cast<int>(nodes.size());
  nodes.push_back(node);
  for (TetId tet : star) {
    TetAtNode entry{tet, 0, {}};
    for (int i = 0; i < 4; ++i) {
      const NodeId corner = mesh.tets[tet][i];
      if (corner == node) entry.corner = i;
      entry.slots[i] = column_of_node[corner] < 0 ? -1 : matrix.slot(row, column_of_node[corner]);
    }
    tets.push_back(entry);
  }
  tet_starts.push_back(static_cast<int>(tets.size()));
}

void ElementRows::assemble(const MatrixFactors& factors, const ElasticLaw& law, std::span<const ElementRest> rests,
                           std::span<const ElementState> states, std::span<const double> masses) {
  parallel_for(matrix.rows(), 256, [&](int begin, int end) {
    for (int row = begin; row < end; ++row) {
      for (int k = matrix.row_starts[row]; k < matrix.row_starts[row + 1]; ++k) matrix.blocks[k].setZero();
      for (int e = tet_starts[row]; e < tet_starts[row + 1]; ++e) {
        const TetAtNode& entry = tets[e];
        const StiffnessRow stiffness = stiffness_row(law, rests[entry.tet], states[entry.tet], entry.corner);
        for (int i = 0; i < 4; ++i)
          if (entry.slots[i] >= 0) matrix.blocks[entry.slots[i]] += factors.stiffness * stiffness.middleCols<3>(3 * i);
      }
      const TetAtNode& any = tets[tet_starts[row]];
      matrix.blocks[any.slots[any.corner]].diagonal().array() += factors.mass * masses[nodes[row]];
    }
  });
}

}  // namespace griffith
