#pragma once

// Small vectors that the compiler keeps in registers, where Eigen's are too many for it.

#include "sim/core/linear_algebra.h"

namespace griffith::contact {

struct Triple {
  double x = 0, y = 0, z = 0;
  Triple() = default;
  Triple(double x_value, double y_value, double z_value) : x(x_value), y(y_value), z(z_value) {}
  explicit Triple(const Vec3& v) : x(v.x()), y(v.y()), z(v.z()) {}
  Vec3 vector() const { return {x, y, z}; }
  Triple operator-() const { return {-x, -y, -z}; }
  Triple& operator+=(const Triple& other) {
    x += other.x, y += other.y, z += other.z;
    return *this;
  }
  Triple& operator-=(const Triple& other) {
    x -= other.x, y -= other.y, z -= other.z;
    return *this;
  }
};

inline Triple operator+(const Triple& a, const Triple& b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
inline Triple operator-(const Triple& a, const Triple& b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
inline Triple operator*(double s, const Triple& v) { return {s * v.x, s * v.y, s * v.z}; }
inline double dot(const Triple& a, const Triple& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
inline Triple cross(const Triple& a, const Triple& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
/// Mᵀ v.
inline Triple transposed_times(const Mat3& m, const Triple& v) {
  return {m(0, 0) * v.x + m(1, 0) * v.y + m(2, 0) * v.z, m(0, 1) * v.x + m(1, 1) * v.y + m(2, 1) * v.z,
          m(0, 2) * v.x + m(1, 2) * v.y + m(2, 2) * v.z};
}

struct Symmetric {
  double xx = 0, xy = 0, xz = 0, yy = 0, yz = 0, zz = 0;
  Symmetric() = default;
  explicit Symmetric(const Mat3& m) : xx(m(0, 0)), xy(m(0, 1)), xz(m(0, 2)), yy(m(1, 1)), yz(m(1, 2)), zz(m(2, 2)) {}
};

inline Triple operator*(const Symmetric& m, const Triple& v) {
  return {m.xx * v.x + m.xy * v.y + m.xz * v.z, m.xy * v.x + m.yy * v.y + m.yz * v.z,
          m.xz * v.x + m.yz * v.y + m.zz * v.z};
}

}  // namespace griffith::contact
