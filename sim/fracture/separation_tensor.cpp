#include "sim/fracture/separation_tensor.h"

#include <algorithm>
#include <cmath>

#include "sim/mesh/topology.h"

namespace griffith {

Mat3 force_dyad(const Vec3& force) {
  const double length = force.norm();
  return length > 0 ? Mat3(force * force.transpose() / length) : Mat3(Mat3::Zero());
}

Mat3 separation_tensor(const SeparationInput& input, NodeId node, bool held) {
  Mat3 sum = Mat3::Zero();
  Vec3 total_tensile = Vec3::Zero(), total_compressive = Vec3::Zero();
  for (TetId tet : input.mesh.stars[node]) {
    const ElementRest& rest = input.rests[tet];
    const ElementState& state = input.states[tet];
    const Vec3 gradient = rest.shape_gradients.col(local_corner(input.mesh, tet, node));
    const Vec3 tensile = -rest.volume * (state.frame * (state.tensile_stress * gradient));
    const Vec3 compressive = -rest.volume * (state.frame * (state.stress * gradient)) - tensile;
    sum += force_dyad(tensile) - force_dyad(compressive);
    total_tensile += tensile;
    total_compressive += compressive;
  }
  if (!held) sum += force_dyad(total_compressive) - force_dyad(total_tensile);
  return 0.5 * sum;
}

double separation_stress(const SeparationInput& input, NodeId node, double eigenvalue, Vec3& direction) {
  double area = 0, volume = 0, largest = 0;
  Mat3 average = Mat3::Zero();
  for (TetId tet : input.mesh.stars[node]) {
    const ElementRest& rest = input.rests[tet];
    const ElementState& state = input.states[tet];
    const Vec3 normal = cofactor(state.frame) * rest.shape_gradients.col(local_corner(input.mesh, tet, node));
    const Mat3 tensile_stress = cauchy_stress(state.frame, state.tensile_stress);
    area += 0.5 * rest.volume * std::abs(normal.dot(direction));
    volume += rest.volume;
    average += rest.volume * tensile_stress;
    largest = std::max(largest, tensile_stress.norm());
  }
  // Where hardly any face meets the plane (a star of one tet, say) the quotient means nothing: no plane can carry more
  // than the stress that is there.
  const double stress = area > 0 ? std::min(eigenvalue / area, largest) : 0;
  const PrincipalValues principal = principal_values(average / volume);
  if (principal.values[2] <= stress) return stress;
  direction = principal.directions.col(2);
  return principal.values[2];
}

}  // namespace griffith
