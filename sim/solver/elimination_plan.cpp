#include "sim/solver/elimination_plan.h"

#include <algorithm>
#include <utility>

#include "sim/core/sort_unique.h"
#include "sim/solver/aggregates.h"

namespace griffith {
namespace {

/// Returns the later rows that each row has entries with, in an order of elimination.
std::vector<std::vector<int>> later_neighbors(const BlockSparseMatrix& pattern, const std::vector<int>& places) {
  std::vector<std::vector<int>> later(pattern.rows());
  for (int row = 0; row < pattern.rows(); ++row)
    for (int k = pattern.row_starts[row]; k < pattern.row_starts[row + 1]; ++k)
      if (places[pattern.columns[k]] > places[row]) later[places[row]].push_back(places[pattern.columns[k]]);
  return later;
}

/// Fronts of one row each.
std::vector<Front> single_fronts(std::vector<std::vector<int>> later) {
  std::vector<Front> fronts(later.size());
  for (int row = 0; row < static_cast<int>(fronts.size()); ++row) {
    sort_unique(later[row]);
    if (later[row].empty()) {
      fronts[row] = {row, 1, {}, -1};
      continue;
    }
    const int parent = later[row].front();
    later[parent].insert(later[parent].end(), later[row].begin() + 1, later[row].end());
    fronts[row] = {row, 1, std::move(later[row]), parent};
  }
  return fronts;
}

/// Zeros that the first of two fronts in a row stores if the second takes it in, in blocks.
std::int64_t zeros_of_joining(const Front& first, const Front& second) {
  return static_cast<std::int64_t>(first.columns) * (second.rows() - static_cast<int>(first.below.size()));
}

/// True if columns that are factored together save more than the zeros that they store cost.
bool pays(std::int64_t zeros, const Front& first, const Front& second) {
  const std::int64_t columns = first.columns + second.columns,
                     all = columns * (columns + 1) / 2 + columns * static_cast<std::int64_t>(second.below.size());
  const double allowed = columns <= 4 ? 0.5 : columns <= 16 ? 0.2 : 0.05;
  return static_cast<double>(zeros) <= allowed * static_cast<double>(all);
}

bool is_child(const Front& before, const Front& front) {
  return !before.below.empty() && before.below.front() < front.first + front.columns;
}

/// Joins fronts to their parents where those follow at once and that pays.
std::vector<Front> join_fronts(std::vector<Front> single) {
  std::vector<Front> joined;
  std::vector<std::int64_t> zeros;  // that each stores
  for (Front& front : single) {
    std::int64_t stored = 0;
    while (!joined.empty() && is_child(joined.back(), front)) {
      const Front& before = joined.back();
      const std::int64_t more = stored + zeros.back() + zeros_of_joining(before, front);
      if (!pays(more, before, front)) break;
      front.first = before.first;
      front.columns += before.columns;
      stored = more;
      joined.pop_back();
      zeros.pop_back();
    }
    joined.push_back(std::move(front));
    zeros.push_back(stored);
  }
  return joined;
}

void find_parents(std::vector<Front>& fronts) {
  for (Front& front : fronts) {
    front.parent = -1;
    if (front.below.empty()) continue;
    const auto after = std::ranges::upper_bound(fronts, front.below.front(), {}, &Front::first);
    front.parent = static_cast<int>(after - fronts.begin()) - 1;
  }
}

}  // namespace

std::int64_t EliminationPlan::entries() const {
  std::int64_t entries = 0;
  for (const Front& front : fronts) entries += std::int64_t{9} * front.columns * front.rows();
  return entries;
}

std::int64_t EliminationPlan::operations() const {
  std::int64_t operations = 0;
  for (const Front& front : fronts) operations += std::int64_t{27} * front.columns * front.rows() * front.rows() / 2;
  return operations;
}

EliminationPlan plan_elimination(const BlockSparseMatrix& pattern) {
  std::vector<std::vector<int>> neighbors(pattern.rows());
  for (int row = 0; row < pattern.rows(); ++row)
    for (int k = pattern.row_starts[row]; k < pattern.row_starts[row + 1]; ++k)
      if (pattern.columns[k] >= row) neighbors[row].push_back(pattern.columns[k]);
  EliminationPlan plan;
  plan.places = elimination_order(neighbors);
  plan.fronts = join_fronts(single_fronts(later_neighbors(pattern, plan.places)));
  find_parents(plan.fronts);
  return plan;
}

}  // namespace griffith
