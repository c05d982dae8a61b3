#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>

namespace griffith {

// Unaligned types: they pack tightly in arrays, are safe members of any value type, and lie alike in memory whatever
// instruction set a source is compiled for. (Three components are never aligned.)
using Vec2 = Eigen::Matrix<double, 2, 1, Eigen::DontAlign>;
using Vec3 = Eigen::Vector3d;
using Mat3 = Eigen::Matrix3d;
using Quat = Eigen::Quaternion<double, Eigen::DontAlign>;

/// A symmetric 3×3 matrix, kept by its upper triangle.
struct SymmetricMat3 {
  double xx = 0, yy = 0, zz = 0, xy = 0, xz = 0, yz = 0;

  Mat3 full() const {
    Mat3 m;
    m << xx, xy, xz, xy, yy, yz, xz, yz, zz;
    return m;
  }
  operator Mat3() const { return full(); }
};

/// det(m) m⁻ᵀ, for singular matrices too: what a deformation m makes of area vectors.
inline Mat3 cofactor(const Mat3& m) {
  Mat3 c;
  c.col(0) = m.col(1).cross(m.col(2));
  c.col(1) = m.col(2).cross(m.col(0));
  c.col(2) = m.col(0).cross(m.col(1));
  return c;
}

/// A rigid placement: world = rotation · local + translation [m].
struct Pose {
  Vec3 translation = Vec3::Zero();
  Quat rotation = Quat::Identity();

  Vec3 to_world(const Vec3& local) const { return rotation * local + translation; }
  Vec3 to_local(const Vec3& world) const { return rotation.conjugate() * (world - translation); }
};

}  // namespace griffith
