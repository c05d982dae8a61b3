#include "sim/fracture/separation_tensor.h"

#include <algorithm>
#include <cmath>

#include "sim/elasticity/corner_traction.h"
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
  return (corners[1] == node) + 2 * (corners[2] == node) + 3 * (corners[3] == node);
}

/// The unit normal n with the largest n·S n / n·T n.
Vec3 weakest_normal(const Mat3& tensor, const DirectionalStrength& strength) {
  if (strength.is_uniform()) return largest_principal(tensor).direction;
  const Mat3 root = strength.inverse_root();
  return (root * largest_principal(root * tensor * root).direction).normalized();
}

/// A split force in the first three lanes; the fourth counts for nothing.
struct ForceLanes {
  simd::WideQuad tensile = {}, compressive = {};
};

ForceLanes force_lanes(const RestElement& rest, const ElementState& state, int corner) {
  const auto gradient = rest.shape_gradients.col(corner);
  const simd::WideQuad part = simd::product(state.tensile_traction.data(), gradient[0], gradient[1], gradient[2]);
  const simd::WideQuad whole = corner_traction(rest, state, corner);
  return {-rest.volume * part, rest.volume * (part - whole)};
}

/// A sum of m(f⁺) − m(f⁻).
struct Dyads {
  simd::WideQuad columns[3] = {};

  /// Adds `factor` times that of the forces: 1 and −1 cancel exactly.
  void add(const ForceLanes& forces, double factor) {
    const simd::WideQuad tensile = direction_of(forces.tensile), compressive = direction_of(forces.compressive);
    for (int i = 0; i < 3; ++i)
      columns[i] += factor * (tensile * forces.tensile[i] - compressive * forces.compressive[i]);
  }

 private:
  static simd::WideQuad direction_of(const simd::WideQuad& force) {
    const double length = std::sqrt(force[0] * force[0] + force[1] * force[1] + force[2] * force[2]);
    return force * (length > 0 ? 1 / length : 0);
  }
};

/// Sums over the elements round a node, seen across a plane.
struct StarSums {
  double area = 0, volume = 0, largest = 0;
  Mat3 tension = Mat3::Zero();  ///< volume times stress
};

StarSums sum_star(const SeparationInput& input, NodeId node, const Vec3& normal) {
  StarSums sums;
  simd::WideQuad tension[3] = {};
  for (TetId tet : input.stars[node]) {
    if (!counts(input, tet, node)) continue;
    const RestElement& rest = input.rest_elements[tet];
    const ElementState& state = input.states[tet];
    const Vec3 across = cofactor(state.frame).transpose() * normal;
    sums.area += 0.5 * rest.volume * std::abs(across.dot(rest.shape_gradients.col(local_corner(input, tet, node))));
    sums.volume += rest.volume;
    for (int i = 0; i < 3; ++i) tension[i] += rest.volume * simd::column(state.tension.data(), i);
    sums.largest = std::max(sums.largest, state.tension_norm);
  }
  sums.tension = simd::matrix_of(tension);
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
  const ForceLanes forces = force_lanes(rest, state, corner);
  return {Vec3(forces.tensile[0], forces.tensile[1], forces.tensile[2]),
          Vec3(forces.compressive[0], forces.compressive[1], forces.compressive[2])};
}

Mat3 separation_tensor(const SeparationInput& input, NodeId node) {
  Dyads sum;
  ForceLanes total;
  for (TetId tet : input.stars[node]) {
    const ForceLanes forces = force_lanes(input.rest_elements[tet], input.states[tet], local_corner(input, tet, node));
    sum.add(forces, 1);
    total.tensile += forces.tensile;
    total.compressive += forces.compressive;
  }
  if (!constrained(input, node)) sum.add(total, -1);
  return 0.5 * simd::matrix_of(sum.columns);
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
