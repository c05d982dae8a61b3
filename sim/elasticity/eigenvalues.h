#pragma once

#include "sim/core/lane_matrices.h"
#include "sim/core/lane_vectors.h"

// Closed forms for symmetric 3×3 matrices, one or four side by side.

namespace griffith::simd {

/// Returns m v.
template <class Real>
Vector3<Real> operator*(const Matrix3<Real>& m, const Vector3<Real>& v) {
  const auto row = [&](int i) { return dot(Vector3<Real>{m.at[i][0], m.at[i][1], m.at[i][2]}, v); };
  return {row(0), row(1), row(2)};
}

/// Returns a times one vector plus b times another.
template <class Real>
Vector3<Real> combined(Real a, const Vector3<Real>& v, Real b, const Vector3<Real>& w) {
  return {a * v.x + b * w.x, a * v.y + b * w.y, a * v.z + b * w.z};
}

/// Returns a unit vector normal to the unit vector n.
template <class Real>
Vector3<Real> unit_across(const Vector3<Real>& n) {
  const Real zero = {}, tiny = 1e-12 * absolute(n.z);
  const auto along_z = (absolute(n.x) <= tiny) & (absolute(n.y) <= tiny);
  const Real length = along_z ? root(n.y * n.y + n.z * n.z) : root(n.x * n.x + n.y * n.y), inverse = 1.0 / length;
  const Vector3<Real> across_x{zero, -n.z * inverse, n.y * inverse}, across_z{-n.y * inverse, n.x * inverse, zero};
  return select(along_z, across_x, across_z);
}

/// Returns cos(⅓ arccos r) for r in [0, 1], the largest root of 4c³ − 3c = r, by Newton's iteration.
template <class Real>
Real cosine_of_third(Real r) {
  Real c = 0.5 + 0.5 * root(0.5 * (1.0 + r));  // within 0.013
  for (int i = 0; i < 3; ++i) c -= ((4.0 * c * c - 3.0) * c - r) / (12.0 * c * c - 3.0);
  return c;
}

/// Returns the largest or smallest eigenvalue, the one farther from the middle one: mean ± 2ρ cos θ with ρ² =
/// |deviator|²/6 and cos 3θ = |det(deviator)|/(2ρ³) (Smith 1961).
template <class Real>
Real isolated_eigenvalue(const Symmetric3<Real>& m) {
  const Real zero = {};
  const Real mean = m.trace() / 3.0;
  const Symmetric3<Real> deviator = add_to_diagonal(m, -mean);
  const Real radius = root(deviator.squared_norm() / 6.0), cube = radius * radius * radius;
  const Real determinant = deviator.determinant();
  const Real quotient = absolute(determinant) / (2.0 * cube);
  const Real bounded = quotient < 1.0 ? quotient : zero + 1.0;
  const Real distance = 2.0 * radius * cosine_of_third<Real>(cube > 0.0 ? bounded : zero);
  return mean + (determinant < 0.0 ? -distance : distance);
}

/// Returns the largest eigenvalue within 2e-8 of the norm. The other two lie symmetrically around their mean, at a
/// distance from the norm of the deviator, whose square may lose half of its digits.
template <class Real>
Real largest_eigenvalue(const Symmetric3<Real>& m) {
  const Real zero = {};
  const Real isolated = isolated_eigenvalue(m), mean = m.trace() / 3.0, apart = isolated - mean;
  const Real square = 0.5 * add_to_diagonal(m, -mean).squared_norm() - 0.75 * apart * apart;
  const Real half_gap = root(square > 0.0 ? square : zero);
  return apart >= 0.0 ? isolated : mean - 0.5 * apart + half_gap;
}

/// Returns a unit eigenvector of an isolated eigenvalue: the longest row of the adjugate of (m − value·I).
template <class Real>
Vector3<Real> eigenvector(const Symmetric3<Real>& m, Real value) {
  const Real zero = {};
  const Symmetric3<Real> s = add_to_diagonal(m, -value);
  const Symmetric3<Real> a{s.yy * s.zz - s.yz * s.yz, s.xx * s.zz - s.xz * s.xz, s.xx * s.yy - s.xy * s.xy,
                           s.xz * s.yz - s.xy * s.zz, s.xy * s.yz - s.xz * s.yy, s.xy * s.xz - s.yz * s.xx};
  // The adjugate is (product of the gaps) n nᵀ, so its diagonal shows the longest row.
  const Real x = absolute(a.xx), y = absolute(a.yy), z = absolute(a.zz);
  const auto y_is_longer = y >= z;
  const Vector3<Real> other{y_is_longer ? a.xy : a.xz, y_is_longer ? a.yy : a.yz, y_is_longer ? a.yz : a.zz};
  const auto other_is_longer = (y > x) | (z > x);
  const Vector3<Real> row{other_is_longer ? other.x : a.xx, other_is_longer ? other.y : a.xy,
                          other_is_longer ? other.z : a.xz};
  const Real length = root(row.x * row.x + row.y * row.y + row.z * row.z);
  const auto found = length > 0.0;
  return {found ? row.x / length : zero + 1.0, found ? row.y / length : zero, found ? row.z / length : zero};
}

/// Eigenvalue and a unit eigenvector of it.
template <class Real>
struct Eigenpair {
  Real value;
  Vector3<Real> direction;
};

/// Returns the eigenpair of the larger eigenvalue in the plane normal to the unit vector n.
template <class Real>
Eigenpair<Real> largest_in_plane(const Matrix3<Real>& m, const Vector3<Real>& n) {
  const Vector3<Real> u = unit_across(n);
  const Vector3<Real> v{n.y * u.z - n.z * u.y, n.z * u.x - n.x * u.z, n.x * u.y - n.y * u.x};
  const Vector3<Real> mv = m * v;
  const Real a = dot(u, m * u), b = dot(u, mv), c = dot(v, mv);
  const Real half = 0.5 * (a - c), radius = hypotenuse(half, b);
  const Vector3<Real> along = select(half >= 0.0, combined(half + radius, u, b, v), combined(b, u, radius - half, v));
  const Real square = dot(along, along), length = root(square);
  const auto is_long = square > 0.0;
  const Vector3<Real> unit{is_long ? along.x / length : along.x, is_long ? along.y / length : along.y,
                           is_long ? along.z / length : along.z};
  return {0.5 * (a + c) + radius, select(radius > 0.0, unit, u)};
}

/// Returns the eigenpair of the largest eigenvalue of a symmetric matrix.
template <class Real>
Eigenpair<Real> largest_eigenpair(const Matrix3<Real>& m) {
  const Symmetric3<Real> upper{m.at[0][0], m.at[1][1], m.at[2][2], m.at[0][1], m.at[0][2], m.at[1][2]};
  const Real isolated = isolated_eigenvalue(upper);
  const Vector3<Real> n = eigenvector(upper, isolated);
  const auto is_largest = 3.0 * isolated >= upper.xx + (upper.yy + upper.zz);
  const Real value = dot(n, m * n);
  if (all_of(is_largest)) return {value, n};
  // The smallest one is isolated, and the largest is in the plane normal to its vector.
  const Eigenpair<Real> in_plane = largest_in_plane(m, n);
  return {is_largest ? value : in_plane.value, select(is_largest, n, in_plane.direction)};
}

/// Returns n·m n.
template <class Real>
Real normal_component(const Symmetric3<Real>& m, const Vector3<Real>& n) {
  return n.x * (m.xx * n.x + m.xy * n.y + m.xz * n.z) + n.y * (m.xy * n.x + m.yy * n.y + m.yz * n.z) +
         n.z * (m.xz * n.x + m.yz * n.y + m.zz * n.z);
}

/// Returns the positive part of a symmetric matrix with eigenvalues `sum`/2 ± d in the plane of the projector, 0 normal
/// to it.
template <class Real>
Symmetric3<Real> positive_part_in_plane(const Symmetric3<Real>& m, const Symmetric3<Real>& projector, Real sum) {
  const Real mean = 0.5 * sum;
  const Symmetric3<Real> deviator = m - mean * projector;
  const Real d = root(0.5 * deviator.squared_norm());
  const Real half = 0.5 * (mean + d) / d;
  const Symmetric3<Real> mixed = half * (deviator - (-d) * projector);
  return select(mean >= d, m, select(mean <= -d, Symmetric3<Real>{}, mixed));
}

/// Returns the sum of max(0, v_i) n_i n_iᵀ over the eigenpairs.
template <class Real>
Symmetric3<Real> tensile_part(const Symmetric3<Real>& s) {
  const Real zero = {};
  const Real trace = s.trace(), squared_norm = s.squared_norm();
  // Do the invariants show that all principal values have one sign, beyond rounding?
  const auto minors_are_positive = s.sum_of_minors() > 0.0;
  const auto is_definite = trace * s.determinant() > 1e-12 * squared_norm * squared_norm;
  const auto one_sign = minors_are_positive & is_definite;
  const Symmetric3<Real> whole = select(trace > 0.0, s, Symmetric3<Real>{});
  if (all_of(one_sign)) return whole;
  // One eigenpair is isolated from the others and removed, which leaves a problem in the plane.
  const Vector3<Real> n = eigenvector(s, isolated_eigenvalue(s));
  const Symmetric3<Real> dyad{n.x * n.x, n.y * n.y, n.z * n.z, n.x * n.y, n.x * n.z, n.y * n.z};
  const Real value = normal_component(s, n);
  const Symmetric3<Real> projector{1.0 - dyad.xx, 1.0 - dyad.yy, 1.0 - dyad.zz, -dyad.xy, -dyad.xz, -dyad.yz};
  const Symmetric3<Real> in_plane = positive_part_in_plane(s - value * dyad, projector, trace - value);
  const Symmetric3<Real> mixed = in_plane - (value > 0.0 ? -value : zero) * dyad;
  return select(one_sign, whole, mixed);
}

}  // namespace griffith::simd
