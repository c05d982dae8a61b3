#include "sim/elasticity/principal_stress.h"

#include <Eigen/Eigenvalues>
#include <cmath>
#include <limits>

#include "sim/elasticity/eigenvalues.h"

namespace griffith {

PrincipalValues principal_values(const Mat3& symmetric) {
  Eigen::SelfAdjointEigenSolver<Mat3> solver;
  solver.computeDirect(symmetric);
  return {solver.eigenvalues(), solver.eigenvectors()};
}

LargestPrincipal largest_principal(const Mat3& symmetric) {
  const auto [value, n] = simd::largest_eigenpair(simd::numbers(symmetric));
  return {value, Vec3(n.x, n.y, n.z)};
}

std::array<LargestPrincipal, 4> largest_principals(const std::array<Mat3, 4>& symmetric) {
  const auto [value, n] = simd::largest_eigenpair(simd::side_by_side(symmetric));
  std::array<LargestPrincipal, 4> found;
  for (int lane = 0; lane < 4; ++lane) found[lane] = {value[lane], Vec3(n.x[lane], n.y[lane], n.z[lane])};
  return found;
}

std::array<double, 4> largest_principal_values(const std::array<Mat3, 4>& symmetric) {
  const simd::Matrix3<simd::DoubleLanes> m = simd::side_by_side(symmetric);
  const simd::DoubleLanes values = simd::largest_eigenvalue(
      simd::Symmetric3<simd::DoubleLanes>{m.at[0][0], m.at[1][1], m.at[2][2], m.at[0][1], m.at[0][2], m.at[1][2]});
  return {values[0], values[1], values[2], values[3]};
}

Vec3 principal_stresses(const Mat3& stress) {
  if (!stress.allFinite()) return Vec3::Constant(std::numeric_limits<double>::quiet_NaN());
  return Eigen::SelfAdjointEigenSolver<Mat3>(stress, Eigen::EigenvaluesOnly).eigenvalues().reverse();
}

double von_mises_stress(const Mat3& stress) {
  const Mat3 deviator = stress - stress.trace() / 3 * Mat3::Identity();
  return std::sqrt(1.5) * deviator.norm();
}

Mat3 tensile_part(const Mat3& stress) { return simd::tensile_part(simd::upper_triangle(stress)).of(0); }

}  // namespace griffith
