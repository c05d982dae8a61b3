#pragma once

#include <algorithm>
#include <numeric>
#include <span>
#include <utility>
#include <vector>

namespace griffith {

/// Disjoint sets of the numbers 0 .. count − 1 (Tarjan 1975). The smallest number identifies a set.
class DisjointSets {
 public:
  explicit DisjointSets(int count) : parents_(count) { std::iota(parents_.begin(), parents_.end(), 0); }

  int find(int i) {
    while (parents_[i] != i) i = parents_[i] = parents_[parents_[i]];
    return i;
  }
  void join(int a, int b) {
    a = find(a), b = find(b);
    parents_[std::max(a, b)] = std::min(a, b);
  }

 private:
  std::vector<int> parents_;
};

/// Returns the connected components of a graph: for each node, the smallest index in its component.
std::vector<int> connected_groups(int count, std::span<const std::pair<int, int>> edges);

}  // namespace griffith
