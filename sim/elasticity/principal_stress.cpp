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
  const simd::Symmetric3<double> m = simd::upper_triangle(symmetric);
  const double isolated = simd::isolated_eigenvalue(m);
  const simd::Vector3<double> n = simd::eigenvector(m, isolated);
  const Vec3 axis(n.x, n.y, n.z);
  if (3 * isolated >= symmetric.trace()) return {axis.dot(symmetric * axis), axis};
  // The smallest one stands apart: the largest is that of the plane across it.
  const Vec3 u = axis.unitOrthogonal(), v = axis.cross(u);
  const double a = u.dot(symmetric * u), b = u.dot(symmetric * v), c = v.dot(symmetric * v);
  const double half = 0.5 * (a - c), radius = std::hypot(half, b);
  const Vec3 direction = half >= 0 ? Vec3((half + radius) * u + b * v) : Vec3(b * u + (radius - half) * v);
  return {0.5 * (a + c) + radius, radius > 0 ? direction.normalized() : u};
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
