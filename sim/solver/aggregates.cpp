#include "sim/solver/aggregates.h"

#include <algorithm>

namespace griffith {
namespace {

/// Adds unassigned rows to `aggregate`, breadth first from `seed`, until it has `target_size` of them. Returns the rows.
std::vector<int> grow(const BlockSparseMatrix& matrix, int seed, int aggregate, int target_size,
                      std::vector<int>& aggregates) {
  std::vector<int> members = {seed};
  aggregates[seed] = aggregate;
  for (std::size_t next = 0; next < members.size(); ++next) {
    const int row = members[next];
    for (int k = matrix.row_starts[row]; k < matrix.row_starts[row + 1]; ++k) {
      if (static_cast<int>(members.size()) >= target_size) return members;
      const int neighbour = matrix.columns[k];
      if (aggregates[neighbour] >= 0) continue;
      aggregates[neighbour] = aggregate;
      members.push_back(neighbour);
    }
  }
  return members;
}

/// An aggregate next to these rows other than their own, or -1.
int adjacent_aggregate(const BlockSparseMatrix& matrix, const std::vector<int>& rows, const std::vector<int>& aggregates) {
  for (int row : rows)
    for (int k = matrix.row_starts[row]; k < matrix.row_starts[row + 1]; ++k)
      if (const int other = aggregates[matrix.columns[k]]; other >= 0 && other != aggregates[row]) return other;
  return -1;
}

}  // namespace

std::vector<int> aggregate_rows(const BlockSparseMatrix& matrix, int target_size) {
  std::vector<int> aggregates(matrix.rows(), -1);
  int count = 0;
  for (int seed = 0; seed < matrix.rows(); ++seed) {
    if (aggregates[seed] >= 0) continue;
    const std::vector<int> members = grow(matrix, seed, count, target_size, aggregates);
    // Left-over islands between grown aggregates join a neighbour: modes of a few nodes cost as much as any others.
    const int neighbour = static_cast<int>(members.size()) * 4 < target_size
                              ? adjacent_aggregate(matrix, members, aggregates)
                              : -1;
    if (neighbour < 0) {
      ++count;
    } else {
      for (int row : members) aggregates[row] = neighbour;
    }
  }
  return aggregates;
}

}  // namespace griffith
