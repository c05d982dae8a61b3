#pragma once

#include <array>
#include <vector>

#include "sim/core/linear_algebra.h"

namespace griffith::testing {

struct Lattice {
  std::vector<Vec3> points;  ///< [m]
  std::vector<std::array<int, 4>> tets;
};

/// Returns a wall of cubic cells, six tets each, without the cells for which `missing` holds.
template <class Missing>
Lattice lattice(int columns, int rows, Missing missing) {
  Lattice body;
  for (int k = 0; k < 2; ++k)
    for (int j = 0; j <= rows; ++j)
      for (int i = 0; i <= columns; ++i) body.points.emplace_back(i, j, k);
  const auto node = [&](int i, int j, int k) { return (k * (rows + 1) + j) * (columns + 1) + i; };
  constexpr int kOrders[6][3] = {{0, 1, 2}, {0, 2, 1}, {1, 0, 2}, {1, 2, 0}, {2, 0, 1}, {2, 1, 0}};
  for (int j = 0; j < rows; ++j)
    for (int i = 0; i < columns; ++i) {
      if (missing(i, j)) continue;
      for (const auto& order : kOrders) {
        int corner[3] = {i, j, 0};
        std::array<int, 4> tet = {node(i, j, 0)};
        for (int step = 0; step < 3; ++step) {
          ++corner[order[step]];
          tet[step + 1] = node(corner[0], corner[1], corner[2]);
        }
        body.tets.push_back(tet);
      }
    }
  return body;
}

}  // namespace griffith::testing
