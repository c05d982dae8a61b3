#include "sim/geometry/disjoint_sets.h"

namespace griffith {

std::vector<int> connected_groups(int count, std::span<const std::pair<int, int>> edges) {
  DisjointSets sets(count);
  for (const auto& [first, second] : edges) sets.join(first, second);
  std::vector<int> groups(count);
  for (int node = 0; node < count; ++node) groups[node] = sets.find(node);
  return groups;
}

}  // namespace griffith
