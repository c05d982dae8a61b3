#pragma once

#include <array>

#include "sim/core/lanes.h"
#include "sim/core/linear_algebra.h"

// 3×3 matrices of numbers (double) or of lanes (DoubleLanes), for one item or four side by side. Products add terms in
// the same order, so that a lane has the bits of the single number.

namespace griffith::simd {

template <class Real>
inline constexpr int kLanesOf = sizeof(Real) / sizeof(double);

inline double lane_of(double x, int) { return x; }
inline double lane_of(const DoubleLanes& x, int lane) { return x[lane]; }
inline bool lane_of(bool x, int) { return x; }
inline bool lane_of(const DoubleMask& x, int lane) { return x[lane] != 0; }
inline void set_lane(double& x, int, double value) { x = value; }
inline void set_lane(DoubleLanes& x, int lane, double value) { x[lane] = value; }

template <class Real>
struct Matrix3 {
  Real at[3][3];  ///< row, column

  Mat3 of(int lane) const {
    Mat3 m;
    for (int j = 0; j < 3; ++j)
      for (int i = 0; i < 3; ++i) m(i, j) = lane_of(at[i][j], lane);
    return m;
  }
  void set(int lane, const Mat3& m) {
    for (int j = 0; j < 3; ++j)
      for (int i = 0; i < 3; ++i) set_lane(at[i][j], lane, m(i, j));
  }
};

inline Matrix3<double> numbers(const Mat3& m) {
  Matrix3<double> copy;
  copy.set(0, m);
  return copy;
}

/// Four matrices side by side.
inline Matrix3<DoubleLanes> side_by_side(const std::array<Mat3, kDoubleLanes>& m) {
  Matrix3<DoubleLanes> lanes;
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) lanes.at[i][j] = DoubleLanes{m[0](i, j), m[1](i, j), m[2](i, j), m[3](i, j)};
  return lanes;
}

template <class Real>
struct Symmetric3 {
  Real xx, yy, zz, xy, xz, yz;

  Real trace() const { return xx + yy + zz; }
  Real squared_norm() const { return xx * xx + yy * yy + zz * zz + 2.0 * (xy * xy + xz * xz + yz * yz); }
  Real sum_of_minors() const { return xx * yy - xy * xy + (xx * zz - xz * xz) + (yy * zz - yz * yz); }
  Real determinant() const { return xx * (yy * zz - yz * yz) - xy * (xy * zz - yz * xz) + xz * (xy * yz - yy * xz); }

  SymmetricMat3 of(int lane) const {
    return {lane_of(xx, lane), lane_of(yy, lane), lane_of(zz, lane),
            lane_of(xy, lane), lane_of(xz, lane), lane_of(yz, lane)};
  }
  /// Adds a symmetric matrix to one lane.
  void add(int lane, const Mat3& m) {
    set_lane(xx, lane, lane_of(xx, lane) + m(0, 0)), set_lane(yy, lane, lane_of(yy, lane) + m(1, 1));
    set_lane(zz, lane, lane_of(zz, lane) + m(2, 2)), set_lane(xy, lane, lane_of(xy, lane) + m(0, 1));
    set_lane(xz, lane, lane_of(xz, lane) + m(0, 2)), set_lane(yz, lane, lane_of(yz, lane) + m(1, 2));
  }
};

/// Returns the upper triangle of a symmetric matrix.
inline Symmetric3<double> upper_triangle(const Mat3& m) {
  return {m(0, 0), m(1, 1), m(2, 2), m(0, 1), m(0, 2), m(1, 2)};
}

template <class Real>
Symmetric3<Real> operator-(const Symmetric3<Real>& a, const Symmetric3<Real>& b) {
  return {a.xx - b.xx, a.yy - b.yy, a.zz - b.zz, a.xy - b.xy, a.xz - b.xz, a.yz - b.yz};
}

template <class Real>
Symmetric3<Real> operator*(Real factor, const Symmetric3<Real>& a) {
  return {factor * a.xx, factor * a.yy, factor * a.zz, factor * a.xy, factor * a.xz, factor * a.yz};
}

template <class Real>
Symmetric3<Real> add_to_diagonal(const Symmetric3<Real>& a, Real value) {
  return {a.xx + value, a.yy + value, a.zz + value, a.xy, a.xz, a.yz};
}

/// Returns a : b, the sum of the products of all components.
template <class Real>
Real contract(const Symmetric3<Real>& a, const Symmetric3<Real>& b) {
  return a.xx * b.xx + a.yy * b.yy + a.zz * b.zz + 2.0 * (a.xy * b.xy + a.xz * b.xz + a.yz * b.yz);
}

/// Returns det(m) m⁻ᵀ.
template <class Real>
Matrix3<Real> cofactor(const Matrix3<Real>& m) {
  Matrix3<Real> c;
  for (int i = 0; i < 3; ++i) {
    const int i1 = (i + 1) % 3, i2 = (i + 2) % 3;
    for (int j = 0; j < 3; ++j) {
      const int j1 = (j + 1) % 3, j2 = (j + 2) % 3;
      c.at[i][j] = m.at[i1][j1] * m.at[i2][j2] - m.at[i2][j1] * m.at[i1][j2];
    }
  }
  return c;
}

/// Returns the determinant of the matrix with this cofactor matrix.
template <class Real>
Real determinant(const Matrix3<Real>& m, const Matrix3<Real>& cofactor) {
  return m.at[0][0] * cofactor.at[0][0] + m.at[1][0] * cofactor.at[1][0] + m.at[2][0] * cofactor.at[2][0];
}

/// Returns sym(aᵀ b).
template <class Real>
Symmetric3<Real> symmetric_product(const Matrix3<Real>& a, const Matrix3<Real>& b) {
  const auto dot = [&](int i, int j) {
    return a.at[0][i] * b.at[0][j] + a.at[1][i] * b.at[1][j] + a.at[2][i] * b.at[2][j];
  };
  return {dot(0, 0),
          dot(1, 1),
          dot(2, 2),
          0.5 * (dot(0, 1) + dot(1, 0)),
          0.5 * (dot(0, 2) + dot(2, 0)),
          0.5 * (dot(1, 2) + dot(2, 1))};
}

template <class Real>
Matrix3<Real> operator*(const Matrix3<Real>& a, const Symmetric3<Real>& s) {
  Matrix3<Real> p;
  for (int i = 0; i < 3; ++i) {
    p.at[i][0] = a.at[i][0] * s.xx + a.at[i][1] * s.xy + a.at[i][2] * s.xz;
    p.at[i][1] = a.at[i][0] * s.xy + a.at[i][1] * s.yy + a.at[i][2] * s.yz;
    p.at[i][2] = a.at[i][0] * s.xz + a.at[i][1] * s.yz + a.at[i][2] * s.zz;
  }
  return p;
}

/// Returns p aᵀ, which must be symmetric.
template <class Real>
Symmetric3<Real> times_transposed(const Matrix3<Real>& p, const Matrix3<Real>& a) {
  const auto dot = [&](int i, int j) {
    return p.at[i][0] * a.at[j][0] + p.at[i][1] * a.at[j][1] + p.at[i][2] * a.at[j][2];
  };
  return {dot(0, 0), dot(1, 1), dot(2, 2), dot(0, 1), dot(0, 2), dot(1, 2)};
}

/// Returns one matrix or the other, lane by lane.
template <class Mask, class Real>
Matrix3<Real> select(const Mask& mask, const Matrix3<Real>& a, const Matrix3<Real>& b) {
  Matrix3<Real> chosen;
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) chosen.at[i][j] = mask ? a.at[i][j] : b.at[i][j];
  return chosen;
}

template <class Mask, class Real>
Symmetric3<Real> select(const Mask& mask, const Symmetric3<Real>& a, const Symmetric3<Real>& b) {
  return {mask ? a.xx : b.xx, mask ? a.yy : b.yy, mask ? a.zz : b.zz,
          mask ? a.xy : b.xy, mask ? a.xz : b.xz, mask ? a.yz : b.yz};
}

}  // namespace griffith::simd
