#pragma once

#include "sim/core/lanes.h"

// Vectors of numbers (double) or of lanes (DoubleLanes), for one item or four side by side. Terms are added in Eigen's
// order, so that a lane has the bits of the single vector.

namespace griffith::simd {

template <class Real>
struct Vector3 {
  Real x, y, z;
};

template <class Real>
Vector3<Real> operator+(const Vector3<Real>& a, const Vector3<Real>& b) {
  return {a.x + b.x, a.y + b.y, a.z + b.z};
}

template <class Real>
Vector3<Real> operator-(const Vector3<Real>& a, const Vector3<Real>& b) {
  return {a.x - b.x, a.y - b.y, a.z - b.z};
}

template <class Real>
Vector3<Real> operator*(const Real& factor, const Vector3<Real>& v) {
  return {factor * v.x, factor * v.y, factor * v.z};
}

template <class Real>
Vector3<Real> operator/(const Vector3<Real>& v, const Real& divisor) {
  return {v.x / divisor, v.y / divisor, v.z / divisor};
}

/// Returns a·b.
template <class Real>
Real dot(const Vector3<Real>& a, const Vector3<Real>& b) {
  return a.x * b.x + (a.y * b.y + a.z * b.z);
}

template <class Real>
Vector3<Real> cross(const Vector3<Real>& a, const Vector3<Real>& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

template <class Mask, class Real>
Vector3<Real> select(const Mask& mask, const Vector3<Real>& a, const Vector3<Real>& b) {
  return {mask ? a.x : b.x, mask ? a.y : b.y, mask ? a.z : b.z};
}

/// Returns the vector in a lane.
inline Vec3 vector_of(const Vector3<DoubleLanes>& v, int lane) { return {v.x[lane], v.y[lane], v.z[lane]}; }

/// Returns four vectors, given as x, y, z and one more, side by side.
inline Vector3<DoubleLanes> side_by_side(WideQuad a, WideQuad b, WideQuad c, WideQuad d) {
  transpose(a, b, c, d);
  return {a, b, c};
}

template <class Real>
Real smaller(const Real& a, const Real& b) {
  return a < b ? a : b;
}
template <class Real>
Real larger(const Real& a, const Real& b) {
  return a > b ? a : b;
}

}  // namespace griffith::simd
