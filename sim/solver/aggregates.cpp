#include "sim/solver/aggregates.h"

#include <Eigen/OrderingMethods>
#include <Eigen/SparseCore>
#include <algorithm>
#include <cstdint>
#include <numeric>

namespace griffith {
namespace {

/// Adds unassigned rows to `aggregate`, breadth first from `seed`, until it has `target_size` of them. Returns the
/// rows.
std::vector<int> grow(const BlockSparseMatrix& matrix, int seed, int aggregate, int target_size,
                      std::vector<int>& aggregates) {
  std::vector<int> members = {seed};
  aggregates[seed] = aggregate;
  for (std::size_t next = 0; next < members.size(); ++next) {
    const int row = members[next];
    for (int k = matrix.row_starts[row]; k < matrix.row_starts[row + 1]; ++k) {
      if (static_cast<int>(members.size()) >= target_size) return members;
      const int neighbor = matrix.columns[k];
      if (aggregates[neighbor] >= 0) continue;
      aggregates[neighbor] = aggregate;
      members.push_back(neighbor);
    }
  }
  return members;
}

/// Returns an aggregate next to these rows other than their own, or -1.
int adjacent_aggregate(const BlockSparseMatrix& matrix, const std::vector<int>& rows,
                       const std::vector<int>& aggregates) {
  for (int row : rows)
    for (int k = matrix.row_starts[row]; k < matrix.row_starts[row + 1]; ++k)
      if (const int other = aggregates[matrix.columns[k]]; other >= 0 && other != aggregates[row]) return other;
  return -1;
}

/// Groups the rows that have no aggregate, from number `count` on.
void group_the_rest(const BlockSparseMatrix& matrix, int target_size, int count, std::vector<int>& aggregates) {
  for (int seed = 0; seed < matrix.rows(); ++seed) {
    if (aggregates[seed] >= 0) continue;
    const std::vector<int> members = grow(matrix, seed, count, target_size, aggregates);
    // Islands between grown aggregates join a neighbor: modes of a few nodes cost as much as any others.
    const int neighbor =
        static_cast<int>(members.size()) * 4 < target_size ? adjacent_aggregate(matrix, members, aggregates) : -1;
    if (neighbor < 0) {
      ++count;
    } else {
      for (int row : members) aggregates[row] = neighbor;
    }
  }
}

void join_neighbors(const BlockSparseMatrix& matrix, std::vector<int>& aggregates) {
  for (int row = 0; row < matrix.rows(); ++row)
    for (int k = matrix.row_starts[row]; k < matrix.row_starts[row + 1] && aggregates[row] < 0; ++k)
      aggregates[row] = aggregates[matrix.columns[k]];
}

/// Marks the rows that `seed` reaches within its aggregate and returns how many they are.
int mark_connected(const BlockSparseMatrix& matrix, const std::vector<int>& aggregates, int seed,
                   std::vector<std::uint8_t>& marked) {
  std::vector<int> reached = {seed};
  marked[seed] = 1;
  for (std::size_t next = 0; next < reached.size(); ++next) {
    const int row = reached[next];
    for (int k = matrix.row_starts[row]; k < matrix.row_starts[row + 1]; ++k) {
      const int neighbor = matrix.columns[k];
      if (marked[neighbor] || aggregates[neighbor] != aggregates[seed]) continue;
      marked[neighbor] = 1;
      reached.push_back(neighbor);
    }
  }
  return static_cast<int>(reached.size());
}

/// Takes the rows of aggregates that are in several parts, or have come down to a few rows, out of them.
void release_broken(const BlockSparseMatrix& matrix, int target_size, int count, std::vector<int>& aggregates) {
  std::vector<std::uint8_t> marked(matrix.rows(), 0), broken(count, 0), seen(count, 0);
  for (int row = 0; row < matrix.rows(); ++row) {
    const int aggregate = aggregates[row];
    if (aggregate < 0 || marked[row]) continue;
    const int size = mark_connected(matrix, aggregates, row, marked);
    if (seen[aggregate] || 4 * size < target_size) broken[aggregate] = 1;
    seen[aggregate] = 1;
  }
  for (int& aggregate : aggregates)
    if (aggregate >= 0 && broken[aggregate]) aggregate = -1;
}

void number_without_gaps(std::vector<int>& aggregates) {
  std::vector<int> numbers(aggregates.empty() ? 0 : *std::max_element(aggregates.begin(), aggregates.end()) + 1, 0);
  for (int aggregate : aggregates) numbers[aggregate] = 1;
  std::exclusive_scan(numbers.begin(), numbers.end(), numbers.begin(), 0);
  for (int& aggregate : aggregates) aggregate = numbers[aggregate];
}

}  // namespace

std::vector<int> aggregate_rows(const BlockSparseMatrix& matrix, int target_size) {
  std::vector<int> aggregates(matrix.rows(), -1);
  group_the_rest(matrix, target_size, 0, aggregates);
  return aggregates;
}

std::vector<int> patch_aggregates(const BlockSparseMatrix& matrix, int target_size, std::vector<int> aggregates) {
  if (aggregates.empty()) return aggregates;
  const int count = *std::max_element(aggregates.begin(), aggregates.end()) + 1;
  join_neighbors(matrix, aggregates);
  release_broken(matrix, target_size, count, aggregates);
  group_the_rest(matrix, target_size, count, aggregates);
  number_without_gaps(aggregates);
  return aggregates;
}

std::vector<int> elimination_order(const std::vector<std::vector<int>>& neighbors) {
  const int count = static_cast<int>(neighbors.size());
  std::vector<Eigen::Triplet<double>> entries;
  for (int a = 0; a < count; ++a)
    for (const int other : neighbors[a]) entries.emplace_back(other, a, 1.0);
  Eigen::SparseMatrix<double> pattern(count, count);
  pattern.setFromTriplets(entries.begin(), entries.end());
  Eigen::AMDOrdering<int>::PermutationType old_numbers;
  Eigen::AMDOrdering<int>()(pattern.selfadjointView<Eigen::Lower>(), old_numbers);
  std::vector<int> numbers(count);
  for (int number = 0; number < count; ++number) numbers[old_numbers.indices()[number]] = number;
  return numbers;
}

}  // namespace griffith
