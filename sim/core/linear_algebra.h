#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>

namespace griffith {

// Unaligned types pack tightly in arrays, are safe members of any value type, and have the same layout with any
// instruction set. (Three components are never aligned.)
using Vec2 = Eigen::Matrix<double, 2, 1, Eigen::DontAlign>;
using Vec3 = Eigen::Vector3d;
using Mat3 = Eigen::Matrix3d;
using Quat = Eigen::Quaternion<double, Eigen::DontAlign>;

/// Symmetric 3×3 matrix, stored as its upper triangle.
struct SymmetricMat3 {
  double xx = 0, yy = 0, zz = 0, xy = 0, xz = 0, yz = 0;

  Mat3 full() const {
    Mat3 m;
    m << xx, xy, xz, xy, yy, yz, xz, yz, zz;
    return m;
  }
  operator Mat3() const { return full(); }
};

/// Returns det(m) m⁻ᵀ, for singular matrices too. A deformation m maps area vectors by it.
inline Mat3 cofactor(const Mat3& m) {
  Mat3 c;
  c.col(0) = m.col(1).cross(m.col(2));
  c.col(1) = m.col(2).cross(m.col(0));
  c.col(2) = m.col(0).cross(m.col(1));
  return c;
}

/// Rigid placement: world = rotation · local + translation [m].
struct Pose {
  Vec3 translation = Vec3::Zero();
  Quat rotation = Quat::Identity();

  Vec3 to_world(const Vec3& local) const { return rotation * local + translation; }
  Vec3 to_local(const Vec3& world) const { return rotation.conjugate() * (world - translation); }
};

}  // namespace griffith
