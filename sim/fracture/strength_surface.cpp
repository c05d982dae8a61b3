#include "sim/fracture/strength_surface.h"

#include <algorithm>
#include <cmath>

#include "sim/elasticity/principal_stress.h"

namespace griffith {
namespace {

/// As equivalent_tension(), of a stress with this trace and squared norm.
double equivalent_tension(double trace, double squared_norm, double ratio) {
  const double second = std::max(0.0, 0.5 * (squared_norm - trace * trace / 3));
  return 0.5 * (1 - ratio) * trace + 0.5 * (1 + ratio) * std::sqrt(3 * second);
}

}  // namespace

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

double separation_load(const SeparationInput& input, NodeId node, const Material& material,
                       const CandidatePlane& plane) {
  if (!material.compressive_strength || material.criterion != FractureCriterion::strength) return plane.stress;
  const Mat3 stress = mean_stress(input, node);
  // The plane's stress is at least the mean tension. Under pressure on all planes it comes on top of the mean stress.
  const double largest = largest_principal(stress).value, replaced = plane.stress + std::min(0.0, largest);
  const double trace = stress.trace() + (replaced - largest),
               squared_norm = stress.squaredNorm() + (replaced * replaced - largest * largest);
  return std::max(0.0,
                  equivalent_tension(trace, squared_norm, material.tensile_strength / *material.compressive_strength));
}

}  // namespace griffith
