#include <algorithm>

#include "sim/core/parallel.h"
#include "sim/core/sort_unique.h"
#include "sim/elasticity/quadratic_stiffness.h"
#include "sim/mesh/topology.h"
#include "sim/solver/element_rows.h"

namespace griffith {

void ElementRows::add_quadratic(const TetMesh& mesh, const TetEdges& topology, NodeId node,
                                const QuadraticColumns& columns) {
  std::vector<std::pair<TetId, int>> star;
  for (const TetId tet : mesh.stars[node]) star.emplace_back(tet, local_corner(mesh, tet, node));
  nodes.push_back(node);
  add_quadratic_row(mesh, topology, star, columns);
}

void ElementRows::add_quadratic(const TetMesh& mesh, const TetEdges& topology, EdgeId edge,
                                const QuadraticColumns& columns) {
  std::vector<std::pair<TetId, int>> star;
  for (const TetId tet : mesh.stars[topology.ends[edge][0]]) {
    const std::array<EdgeId, 6>& of_tet = topology.of_tet[tet];
    if (const auto found = std::ranges::find(of_tet, edge); found != of_tet.end())
      star.emplace_back(tet, 4 + static_cast<int>(found - of_tet.begin()));
  }
  edges.push_back(edge);
  add_quadratic_row(mesh, topology, star, columns);
}

void ElementRows::add_quadratic_row(const TetMesh& mesh, const TetEdges& topology,
                                    std::span<const std::pair<TetId, int>> star, const QuadraticColumns& columns) {
  std::vector<int> found;
  for (const auto& [tet, own] : star) {
    for (const NodeId corner : mesh.tets[tet]) found.push_back(columns.of_node(corner));
    for (const EdgeId edge : topology.of_tet[tet]) found.push_back(columns.of_edge(edge));
  }
  std::erase_if(found, [](int column) { return column < 0; });
  sort_unique(found);
  matrix.columns.insert(matrix.columns.end(), found.begin(), found.end());
  matrix.row_starts.push_back(static_cast<int>(matrix.columns.size()));
  const auto slot_of = [&](int column) {
    return column < 0 ? -1 : static_cast<int>(std::ranges::lower_bound(found, column) - found.begin());
  };
  for (const auto& [tet, own] : star) {
    TetAtNode& entry = tets.emplace_back(TetAtNode{tet, own, {}});
    for (int i = 0; i < 4; ++i) entry.slots[i] = slot_of(columns.of_node(mesh.tets[tet][i]));
    std::array<int, 6>& slots = edge_slots.emplace_back();
    for (int i = 0; i < 6; ++i) slots[i] = slot_of(columns.of_edge(topology.of_tet[tet][i]));
  }
  tet_starts.push_back(static_cast<int>(tets.size()));
}

void ElementRows::assemble_quadratic(const MatrixFactors& factors, const ElasticLaw& law,
                                     std::span<const RestElement> rest_elements, std::span<const ElementState> states,
                                     std::span<const double> masses, std::span<const double> edge_masses) {
  parallel_for(matrix.rows(), 64, [&](int begin, int end) {
    for (int row = begin; row < end; ++row) {
      const int first = matrix.row_starts[row], last = matrix.row_starts[row + 1];
      std::vector<simd::WideQuad> columns(3 * static_cast<std::size_t>(last - first), simd::WideQuad{});
      const auto add = [&](const simd::WideQuad* block, int slot) {
        for (int k = 0; k < 3 && slot >= 0; ++k) columns[3 * slot + k] += block[k];
      };
      int diagonal = 0;
      for (int e = tet_starts[row]; e < tet_starts[row + 1]; ++e) {
        const auto& [tet, own, slots] = tets[e];
        const QuadraticStiffnessRow stiffness =
            quadratic_stiffness_row(law, rest_elements[tet], states[tet], own, factors.stiffness);
        for (int i = 0; i < 4; ++i) add(stiffness.columns + 3 * i, slots[i]);
        for (int i = 0; i < 6; ++i) add(stiffness.columns + 3 * (4 + i), edge_slots[e][i]);
        diagonal = own < 4 ? slots[own] : edge_slots[e][own - 4];
      }
      for (int k = first; k < last; ++k) matrix.blocks[k] = simd::matrix_of(&columns[3 * (k - first)]);
      const auto node = static_cast<std::size_t>(row);
      const double mass = node < nodes.size() ? masses[nodes[node]] : edge_masses[edges[node - nodes.size()]];
      matrix.blocks[first + diagonal].diagonal().array() += factors.mass * mass;
    }
  });
}

}  // namespace griffith
