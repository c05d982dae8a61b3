#pragma once

#include <span>
#include <utility>
#include <vector>

namespace griffith::contact {

/// The connected components of a graph: per node the smallest index in its component.
std::vector<int> connected_groups(int count, std::span<const std::pair<int, int>> edges);

}  // namespace griffith::contact
