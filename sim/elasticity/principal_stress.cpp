#include "sim/elasticity/principal_stress.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <limits>

namespace griffith {
namespace {

/// The upper triangle of a symmetric matrix: what the closed forms below need, in registers.
struct Symmetric {
  double xx, yy, zz, xy, xz, yz;

  double squared_norm() const { return xx * xx + yy * yy + zz * zz + 2 * (xy * xy + xz * xz + yz * yz); }
  double sum_of_minors() const { return xx * yy - xy * xy + (xx * zz - xz * xz) + (yy * zz - yz * yz); }
  double determinant() const { return xx * (yy * zz - yz * yz) - xy * (xy * zz - yz * xz) + xz * (xy * yz - yy * xz); }
};

Symmetric minus_diagonal(const Mat3& m, double value) {
  return {m(0, 0) - value, m(1, 1) - value, m(2, 2) - value, m(0, 1), m(0, 2), m(1, 2)};
}

/// cos(⅓ arccos r) for r in [0, 1], the largest root of 4c³ − 3c = r, by Newton's iteration.
double cosine_of_third(double r) {
  double c = 0.5 + 0.5 * std::sqrt(0.5 * (1 + r));  // within 0.013
  for (int i = 0; i < 3; ++i) c -= ((4 * c * c - 3) * c - r) / (12 * c * c - 3);
  return c;
}

/// The largest or smallest eigenvalue, whichever lies apart from the middle one: mean ± 2ρ cos θ with
/// ρ² = |deviator|²/6 and cos 3θ = |det(deviator)|/(2ρ³) (Smith 1961).
double isolated_eigenvalue(const Mat3& m) {
  const double mean = m.trace() / 3;
  const Symmetric deviator = minus_diagonal(m, mean);
  const double radius = std::sqrt(deviator.squared_norm() / 6), cube = radius * radius * radius;
  const double determinant = deviator.determinant();
  const double cosine = cube > 0 ? std::min(std::abs(determinant) / (2 * cube), 1.0) : 0;
  return mean + std::copysign(2 * radius * cosine_of_third(cosine), determinant);
}

/// A unit eigenvector of an isolated eigenvalue: the longest row of the adjugate of (m − value·I).
Vec3 eigenvector(const Mat3& m, double value) {
  const Symmetric s = minus_diagonal(m, value);
  const Symmetric a{s.yy * s.zz - s.yz * s.yz, s.xx * s.zz - s.xz * s.xz, s.xx * s.yy - s.xy * s.xy,
                    s.xz * s.yz - s.xy * s.zz, s.xy * s.yz - s.xz * s.yy, s.xy * s.xz - s.yz * s.xx};
  // The adjugate is (product of the gaps) n nᵀ: its diagonal tells which row is long.
  const double x = std::abs(a.xx), y = std::abs(a.yy), z = std::abs(a.zz);
  const Vec3 row = x >= y && x >= z ? Vec3(a.xx, a.xy, a.xz) : y >= z ? Vec3(a.xy, a.yy, a.yz) : Vec3(a.xz, a.yz, a.zz);
  const double length = row.norm();
  return length > 0 ? Vec3(row / length) : Vec3(Vec3::UnitX());
}

/// The positive part of a symmetric matrix with eigenvalues `sum`/2 ± d in the plane of the projector, 0 across it.
Mat3 positive_part_in_plane(const Mat3& m, const Mat3& projector, double sum) {
  const double mean = 0.5 * sum;
  const Mat3 deviator = m - mean * projector;
  const double d = std::sqrt(0.5 * deviator.squaredNorm());
  if (mean >= d) return m;
  if (mean <= -d) return Mat3::Zero();
  return (0.5 * (mean + d) / d) * (deviator + d * projector);
}

}  // namespace

PrincipalValues principal_values(const Mat3& symmetric) {
  Eigen::SelfAdjointEigenSolver<Mat3> solver;
  solver.computeDirect(symmetric);
  return {solver.eigenvalues(), solver.eigenvectors()};
}

LargestPrincipal largest_principal(const Mat3& symmetric) {
  const double isolated = isolated_eigenvalue(symmetric);
  const Vec3 axis = eigenvector(symmetric, isolated);
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

Mat3 tensile_part(const Mat3& stress) {
  const Symmetric s = minus_diagonal(stress, 0);
  const double trace = s.xx + s.yy + s.zz, squared_norm = s.squared_norm();
  // By their invariants, are all principal values of one sign, beyond rounding?
  if (s.sum_of_minors() > 0 && trace * s.determinant() > 1e-12 * squared_norm * squared_norm)
    return trace > 0 ? stress : Mat3(Mat3::Zero());
  // One eigenpair stands apart from the others and is taken off; what is left is a problem in the plane.
  const Vec3 axis = eigenvector(stress, isolated_eigenvalue(stress));
  const Mat3 dyad = axis * axis.transpose();
  const double value = axis.dot(stress * axis);
  return std::max(value, 0.0) * dyad +
         positive_part_in_plane(stress - value * dyad, Mat3::Identity() - dyad, trace - value);
}

}  // namespace griffith
