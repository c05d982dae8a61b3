#include "sim/solver/element_rows.h"

#include <algorithm>
#include <cassert>
#include <cstdint>
#include <utility>

#include "sim/core/parallel.h"
#include "sim/elasticity/stiffness.h"

namespace griffith {
namespace {

/// Where each of `nodes` is in `rows`, both ascending; -1 for those that are not.
std::vector<int> find_rows(const std::vector<NodeId>& rows, std::span<const NodeId> nodes) {
  std::vector<int> found;
  found.reserve(nodes.size());
  std::size_t row = 0;
  for (NodeId node : nodes) {
    while (row < rows.size() && rows[row] < node) ++row;
    found.push_back(row < rows.size() && rows[row] == node ? static_cast<int>(row) : -1);
  }
  return found;
}

}  // namespace

void ElementRows::add(const TetMesh& mesh, NodeId node, std::span<const int> column_of_node) {
  const auto column_of = [&](NodeId corner) {
    return column_of_node.empty() ? corner.index() : column_of_node[corner];
  };
  const std::vector<TetId>& star = mesh.stars[node];
  std::vector<int>& columns = matrix.columns;
  const std::ptrdiff_t first = static_cast<std::ptrdiff_t>(columns.size());
  for (TetId tet : star)
    for (NodeId corner : mesh.tets[tet])
      if (column_of(corner) >= 0) columns.push_back(column_of(corner));
  std::sort(columns.begin() + first, columns.end());
  columns.erase(std::unique(columns.begin() + first, columns.end()), columns.end());
  matrix.row_starts.push_back(static_cast<int>(columns.size()));

  const int row = static_cast<int>(nodes.size());
  nodes.push_back(node);
  for (TetId tet : star) {
    TetAtNode entry{tet, 0, {}};
    for (int i = 0; i < 4; ++i) {
      const NodeId corner = mesh.tets[tet][i];
      if (corner == node) entry.corner = i;
      entry.slots[i] = column_of(corner) < 0 ? -1 : matrix.slot(row, column_of(corner)) - first;
    }
    tets.push_back(entry);
  }
  tet_starts.push_back(static_cast<int>(tets.size()));
}

void ElementRows::keep(const ElementRows& from, int row, std::span<const int> column_of_node) {
  const int first = from.matrix.row_starts[row], last = from.matrix.row_starts[row + 1];
  const int shift = static_cast<int>(matrix.columns.size()) - first;
  for (int k = first; k < last; ++k) {
    matrix.columns.push_back(column_of_node[from.nodes[from.matrix.columns[k]]]);
    assert(matrix.columns.back() >= 0);
  }
  matrix.row_starts.push_back(last + shift);
  nodes.push_back(from.nodes[row]);
  tets.insert(tets.end(), from.tets.begin() + from.tet_starts[row], from.tets.begin() + from.tet_starts[row + 1]);
  tet_starts.push_back(static_cast<int>(tets.size()));
}

std::vector<int> ElementRows::patch(const TetMesh& mesh, std::span<const NodeId> node_list,
                                    std::span<const int> column_of_node) {
  const std::vector<int> previous = find_rows(nodes, node_list);
  // A row changes when its node has lost tets or has a new neighbor.
  std::vector<std::uint8_t> changed(node_list.size(), 0);
  for (std::size_t row = 0; row < node_list.size(); ++row) {
    const std::vector<TetId>& star = mesh.stars[node_list[row]];
    if (const int before = previous[row]; before >= 0) {
      if (static_cast<int>(star.size()) != tet_starts[before + 1] - tet_starts[before]) changed[row] = 1;
      continue;
    }
    for (TetId tet : star)
      for (NodeId corner : mesh.tets[tet])
        if (column_of_node[corner] >= 0) changed[column_of_node[corner]] = 1;
  }
  ElementRows patched;
  patched.nodes.reserve(node_list.size());
  patched.matrix.row_starts.reserve(node_list.size() + 1);
  patched.matrix.columns.reserve(matrix.columns.size());
  patched.tet_starts.reserve(node_list.size() + 1);
  patched.tets.reserve(tets.size());
  patched.matrix.blocks = std::move(matrix.blocks);
  for (std::size_t row = 0; row < node_list.size(); ++row) {
    if (changed[row]) {
      patched.add(mesh, node_list[row], column_of_node);
    } else {
      patched.keep(*this, previous[row], column_of_node);
    }
  }
  patched.allocate();
  *this = std::move(patched);
  return previous;
}

void ElementRows::assemble(const MatrixFactors& factors, const ElasticLaw& law,
                           std::span<const RestElement> rest_elements, std::span<const ElementState> states,
                           std::span<const double> masses, std::span<const double> edge_masses) {
  if (!edge_slots.empty()) return assemble_quadratic(factors, law, rest_elements, states, masses, edge_masses);
  assemble_rows(factors.mass, masses, [&](const TetAtNode& entry) {
    return stiffness_row(law, rest_elements[entry.tet], states[entry.tet], entry.corner, factors.stiffness);
  });
}

void ElementRows::assemble(const MatrixFactors& factors, std::span<const RestElement> rest_elements,
                           std::span<const TangentStiffness> tangents, std::span<const double> masses) {
  assemble_rows(factors.mass, masses, [&](const TetAtNode& entry) {
    return tangents[entry.tet].row(rest_elements[entry.tet], entry.corner, factors.stiffness);
  });
}

/// `row_of`: the stiffness of a tet, the row of one of its corners.
template <class RowOf>
void ElementRows::assemble_rows(double of_mass, std::span<const double> masses, const RowOf& row_of) {
  parallel_for(matrix.rows(), 256, [&](int begin, int end) {
    std::vector<simd::WideQuad> columns;  // of the row's blocks
    for (int row = begin; row < end; ++row) {
      const int first = matrix.row_starts[row], last = matrix.row_starts[row + 1];
      columns.assign(3 * static_cast<std::size_t>(last - first), simd::WideQuad{});
      for (int e = tet_starts[row]; e < tet_starts[row + 1]; ++e) {
        const TetAtNode& entry = tets[e];
        const StiffnessRow stiffness = row_of(entry);
        for (int i = 0; i < 4; ++i)
          for (int k = 0; k < 3 && entry.slots[i] >= 0; ++k)
            columns[3 * entry.slots[i] + k] += stiffness.columns[3 * i + k];
      }
      for (int k = first; k < last; ++k) matrix.blocks[k] = simd::matrix_of(&columns[3 * (k - first)]);
      const TetAtNode& any = tets[tet_starts[row]];
      matrix.blocks[first + any.slots[any.corner]].diagonal().array() += of_mass * masses[nodes[row]];
    }
  });
}

}  // namespace griffith
