#pragma once

#include "sim/core/lane_matrices.h"

namespace griffith::simd {

/// Returns polar_rotation() if the iteration of rotation_of() fails.
Mat3 polar_rotation_by_svd(const Mat3& deformation_gradient);

/// Returns polar_rotation() of each lane by Newton's iteration Q <- (Q + Q⁻ᵀ)/2 (Higham 1986): two or three rounds for
/// the small strains of stiff bodies.
template <class Real>
Matrix3<Real> rotation_of(const Matrix3<Real>& gradient) {
  constexpr int kMaxIterations = 12;
  // Of the squared change. Convergence is quadratic, and leaves half the square of the change: 5e-15.
  constexpr double kTolerance = 1e-14;
  Matrix3<Real> q = gradient;
  auto is_searching = (Real{} < 1.0);
  auto is_found = !is_searching;
  for (int i = 0; i < kMaxIterations && any_of(is_searching); ++i) {
    const Matrix3<Real> c = cofactor(q);
    const Real det = determinant(q, c);
    is_searching = is_searching & (det > 1e-3);
    Matrix3<Real> next;
    Real change = {};
    for (int j = 0; j < 3; ++j)
      for (int k = 0; k < 3; ++k) {
        next.at[k][j] = 0.5 * (q.at[k][j] + c.at[k][j] / det);
        const Real difference = next.at[k][j] - q.at[k][j];
        change += difference * difference;
      }
    q = select(is_searching, next, q);
    is_found = is_found | (is_searching & (change < kTolerance));
    is_searching = is_searching & !is_found;
  }
  for (int lane = 0; lane < kLanesOf<Real>; ++lane)
    if (!lane_of(is_found, lane)) q.set(lane, polar_rotation_by_svd(gradient.of(lane)));
  return q;
}

}  // namespace griffith::simd
