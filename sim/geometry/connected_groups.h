#pragma once

#include <span>
#include <utility>
#include <vector>

namespace griffith::contact {

/// Returns the connected components of a graph: for each node, the smallest index in its component.
std::vector<int> connected_groups(int count, std::span<const std::pair<int, int>> edges);

}  // namespace griffith::contact
