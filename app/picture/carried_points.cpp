#include "app/picture/carried_points.h"

#include <algorithm>
#include <cmath>

namespace griffith::app {

std::vector<std::array<int, 4>> summation_orders(const Frame& frame) {
  std::vector<std::array<int, 4>> orders(frame.elements.tets.size(), {0, 1, 2, 3});
  for (std::size_t tet = 0; tet < orders.size(); ++tet) {
    std::ranges::sort(orders[tet], [&](int a, int b) {
      const Vec3& at_a = frame.nodes.rest_positions[frame.elements.tets[tet][a]];
      const Vec3& at_b = frame.nodes.rest_positions[frame.elements.tets[tet][b]];
      return std::lexicographical_compare(at_a.begin(), at_a.end(), at_b.begin(), at_b.end());
    });
  }
  return orders;
}

render::Weights ordered(const Weights& weights, const std::array<int, 4>& order) {
  constexpr float kRounding = 1e-7f;
  render::Weights result;
  for (int i = 0; i < 4; ++i) result[i] = std::abs(weights[order[i]]) < kRounding ? 0 : weights[order[i]];
  return result;
}

std::vector<std::array<std::int32_t, 4>> ordered_tets(const Frame& frame, std::span<const std::array<int, 4>> orders) {
  std::vector<std::array<std::int32_t, 4>> tets(frame.elements.tets.size());
  for (std::size_t tet = 0; tet < tets.size(); ++tet)
    for (int i = 0; i < 4; ++i)
      tets[tet][i] = frame.elements.tets[tet][tet < orders.size() ? orders[tet][i] : i].index();
  return tets;
}

}  // namespace griffith::app
