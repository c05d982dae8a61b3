#include "sim/fracture/strength_surface.h"

#include <algorithm>
#include <cmath>

namespace griffith {

double equivalent_tension(double trace, double squared_norm, double strength_ratio) {
  const double second = std::max(0.0, 0.5 * (squared_norm - trace * trace / 3));
  return 0.5 * (1 - strength_ratio) * trace + 0.5 * (1 + strength_ratio) * std::sqrt(3 * second);
}

double equivalent_tension(const Mat3& stress, double strength_ratio) {
  return equivalent_tension(stress.trace(), stress.squaredNorm(), strength_ratio);
}

Mat3 mean_stress(const SeparationInput& input, NodeId node) {
  const bool constrained = is_constrained(input, node);
  Mat3 sum = Mat3::Zero();
  double volume = 0;
  for (const TetId tet : input.stars[node]) {
    if (constrained && is_anchored(input, tet)) continue;
    const auto& corners = input.tets[tet];
    const auto corner = static_cast<int>(std::ranges::find(corners, node) - corners.begin());
    const ElementState& state = input.state_at(tet, corner);
    sum += input.rest_elements[tet].volume * cauchy_stress(state.frame, state.stress);
    volume += input.rest_elements[tet].volume;
  }
  return volume > 0 ? Mat3(sum / volume) : sum;
}

}  // namespace griffith
