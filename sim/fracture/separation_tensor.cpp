#include "sim/fracture/separation_tensor.h"

#include <algorithm>
#include <cmath>

#include "sim/elasticity/principal_stress.h"

namespace griffith {
namespace {

bool constrained(const SeparationInput& input, NodeId node) {
  return !input.constraints.empty() && !input.constraints[node].is_free();
}

bool anchored(const SeparationInput& input, TetId tet) {
  const auto& corners = input.tets[tet];
  return std::all_of(corners.begin(), corners.end(),
                     [&](NodeId corner) { return input.constraints[corner].is_held(); });
}

bool counts(const SeparationInput& input, TetId tet, NodeId node) {
  return !constrained(input, node) || !anchored(input, tet);
}

int local_corner(const SeparationInput& input, TetId tet, NodeId node) {
  const auto& corners = input.tets[tet];
  return static_cast<int>(std::ranges::find(corners, node) - corners.begin());
}

/// The unit normal n with the largest n·S n / n·T n.
Vec3 weakest_normal(const Mat3& tensor, const DirectionalStrength& strength) {
  if (strength.is_uniform()) return largest_principal(tensor).direction;
  const Mat3 root = strength.inverse_root();
  return (root * largest_principal(root * tensor * root).direction).normalized();
}

/// Sums over the elements round a node, seen across a plane.
struct StarSums {
  double area = 0, volume = 0, largest = 0;
  Mat3 tension = Mat3::Zero();  ///< volume times stress
};

StarSums sum_star(const SeparationInput& input, NodeId node, const Vec3& normal) {
  StarSums sums;
  for (TetId tet : input.stars[node]) {
    if (!counts(input, tet, node)) continue;
    const RestElement& rest = input.rest_elements[tet];
    const ElementState& state = input.states[tet];
    const Vec3 face = cofactor(state.frame) * rest.shape_gradients.col(local_corner(input, tet, node));
    sums.area += 0.5 * rest.volume * std::abs(face.dot(normal));
    sums.volume += rest.volume;
    sums.tension += rest.volume * state.tension;
    sums.largest = std::max(sums.largest, state.tension_norm);
  }
  return sums;
}

}  // namespace

Mat3 force_dyad(const Vec3& force) {
  const double length = force.norm();
  return length > 0 ? Mat3(force * force.transpose() * (1 / length)) : Mat3(Mat3::Zero());
}

SplitForce split_force(const SeparationInput& input, TetId tet, NodeId node) {
  return split_force(input.rest_elements[tet], input.states[tet], local_corner(input, tet, node));
}

SplitForce split_force(const RestElement& rest, const ElementState& state, int corner) {
  const Vec3 gradient = rest.shape_gradients.col(corner);
  const Vec3 tensile = -rest.volume * (state.frame * (state.tensile_stress * gradient));
  return {tensile, -rest.volume * (state.frame * (state.stress * gradient)) - tensile};
}

Mat3 separation_tensor(const SeparationInput& input, NodeId node) {
  Mat3 sum = Mat3::Zero();
  SplitForce total;
  for (TetId tet : input.stars[node]) {
    const SplitForce force = split_force(input, tet, node);
    sum += force_dyad(force.tensile) - force_dyad(force.compressive);
    total.tensile += force.tensile;
    total.compressive += force.compressive;
  }
  if (!constrained(input, node)) sum += force_dyad(total.compressive) - force_dyad(total.tensile);
  return 0.5 * sum;
}

CandidatePlane candidate_plane(const SeparationInput& input, NodeId node, const Mat3& tensor,
                               const DirectionalStrength& strength) {
  const auto [largest_eigenvalue, pulled] = largest_principal(tensor);
  CandidatePlane plane;
  plane.normal = strength.is_uniform() ? pulled : weakest_normal(tensor, strength);
  plane.pulled = plane.normal;
  plane.eigenvalue = plane.normal.dot(tensor * plane.normal);
  const StarSums sums = sum_star(input, node, pulled);
  plane.volume = sums.volume;
  if (sums.volume == 0) return plane;
  // Where hardly any face meets the plane (a star of one tet, say) the quotient means nothing: no plane can carry more
  // than the stress that is there.
  if (largest_eigenvalue > 0 && sums.area > 0)
    plane.stress = std::min(1 / sums.area, sums.largest / largest_eigenvalue) * plane.eigenvalue;

  const Mat3 average = sums.tension / sums.volume;
  if (strength.is_uniform() && average.norm() <= plane.stress) return plane;  // no plane has more than that
  const Vec3 normal = weakest_normal(average, strength);
  const double stress = normal.dot(average * normal);
  if (stress * strength.fraction(plane.normal) <= plane.stress * strength.fraction(normal)) return plane;
  return {normal, plane.eigenvalue, stress, true, plane.pulled, sums.volume};
}

double tension_fraction(const SeparationInput& input, TetId tet, NodeId node, const CandidatePlane& plane) {
  if (!counts(input, tet, node)) return 0;
  const ElementState& state = input.states[tet];
  return input.rest_elements[tet].volume / plane.volume * plane.normal.dot(state.tension * plane.normal);
}

DirectionalStrength strength_at(const SeparationInput& input, NodeId node, const Weakness& weakness) {
  Vec3 axis = Vec3::Zero();
  for (TetId tet : input.stars[node])
    axis += input.rest_elements[tet].volume * (input.states[tet].frame * weakness.direction);
  return directional_strength(weakness, axis.normalized());
}

}  // namespace griffith
