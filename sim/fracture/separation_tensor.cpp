#include "sim/fracture/separation_tensor.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>

#include "sim/mesh/topology.h"

namespace griffith {
PrincipalValues principal_values(const Mat3& symmetric) {
  Eigen::SelfAdjointEigenSolver<Mat3> solver;
  solver.computeDirect(symmetric);
  return {solver.eigenvalues(), solver.eigenvectors()};
}

Mat3 tensile_part(const Mat3& stress) {
  const PrincipalValues principal = principal_values(stress);
  if (principal.values[2] <= 0) return Mat3::Zero();
  if (principal.values[0] >= 0) return stress;
  return principal.directions * principal.values.cwiseMax(0).asDiagonal() * principal.directions.transpose();
}

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
    const Vec3 tensile = -rest.volume * (state.rotation * (input.tensile_stresses[tet] * gradient));
    const Vec3 compressive = -rest.volume * (state.rotation * (state.stress * gradient)) - tensile;
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
    const Mat3& rotation = input.states[tet].rotation;
    const Vec3 gradient = rotation * rest.shape_gradients.col(local_corner(input.mesh, tet, node));
    area += 0.5 * rest.volume * std::abs(gradient.dot(direction));
    volume += rest.volume;
    average += rest.volume * (rotation * input.tensile_stresses[tet] * rotation.transpose());
    largest = std::max(largest, input.tensile_stresses[tet].norm());
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
