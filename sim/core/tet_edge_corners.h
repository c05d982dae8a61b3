#pragma once

#include <array>

namespace griffith {

/// Corners at the ends of a tet's six edges.
inline constexpr std::array<std::array<int, 2>, 6> kTetEdges = {{{0, 1}, {0, 2}, {0, 3}, {1, 2}, {1, 3}, {2, 3}}};

/// Returns the edge between two corners of a tet.
constexpr int tet_edge(int a, int b) {
  for (int edge = 0; edge < 6; ++edge)
    if (kTetEdges[edge] == std::array{a, b} || kTetEdges[edge] == std::array{b, a}) return edge;
  return -1;
}

}  // namespace griffith
