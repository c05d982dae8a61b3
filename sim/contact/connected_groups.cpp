#include "sim/contact/connected_groups.h"

#include <algorithm>
#include <numeric>

namespace griffith::contact {

std::vector<int> connected_groups(int count, std::span<const std::pair<int, int>> edges) {
  std::vector<int> parents(count);
  std::iota(parents.begin(), parents.end(), 0);
  const auto root = [&](int node) {
    while (parents[node] != node) node = parents[node] = parents[parents[node]];
    return node;
  };
  for (const auto& [first, second] : edges) {
    const auto [smaller, larger] = std::minmax({root(first), root(second)});
    parents[larger] = smaller;
  }
  for (int node = 0; node < count; ++node) parents[node] = root(node);
  return parents;
}

}  // namespace griffith::contact
