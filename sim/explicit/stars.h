#pragma once

#include <vector>

namespace griffith {

/// Lists the entries of elements that act on each node or edge. `each_entry(use)` calls use(index of item, entry) for
/// every entry, in the same order each time. An item's range of `stars` is [first, first + count), in the order of the
/// calls.
template <class Item, class EachEntry>
void list_stars(const EachEntry& each_entry, std::vector<Item>& items, std::vector<int>& stars) {
  each_entry([&](int item, int) { ++items[item].count; });
  int first = 0;
  for (Item& item : items) {
    item.first = first;
    first += item.count;
  }
  stars.resize(first);
  std::vector<int> fill(items.size(), 0);
  each_entry([&](int item, int entry) { stars[items[item].first + fill[item]++] = entry; });
}

}  // namespace griffith
