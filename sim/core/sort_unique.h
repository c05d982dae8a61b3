#pragma once

#include <algorithm>
#include <vector>

namespace griffith {

/// Sorts items and removes duplicates.
template <class T>
void sort_unique(std::vector<T>& items) {
  std::ranges::sort(items);
  const auto repeated = std::ranges::unique(items);
  items.erase(repeated.begin(), repeated.end());
}

}  // namespace griffith
