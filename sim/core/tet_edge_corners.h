#pragma once

#include <array>

namespace griffith {

/// Corners at the ends of a tet's six edges.
inline constexpr std::array<std::array<int, 2>, 6> kTetEdges = {{{0, 1}, {0, 2}, {0, 3}, {1, 2}, {1, 3}, {2, 3}}};

}  // namespace griffith
