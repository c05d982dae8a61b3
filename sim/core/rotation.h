#pragma once

#include "sim/core/linear_algebra.h"

namespace griffith {

/// Returns [v]×, for which [v]× w = v × w.
inline Mat3 cross_matrix(const Vec3& v) {
  Mat3 m;
  m << 0, -v.z(), v.y(), v.z(), 0, -v.x(), -v.y(), v.x(), 0;
  return m;
}

/// Returns the rotation about a vector by its length [rad].
inline Eigen::AngleAxisd rotation_by(const Vec3& vector) {
  const double angle = vector.norm();
  return angle > 0 ? Eigen::AngleAxisd(angle, vector / angle) : Eigen::AngleAxisd::Identity();
}

/// Returns the rotation of a free rigid body over `dt` [s], with constant angular momentum and an inertia [kg·m²] that
/// rotates with the body. Angular momentum and kinetic energy are kept to rounding at any speed. Second order (implicit
/// midpoint, projected back onto the energy) up to about a radian; beyond that, a steady rotation about the momentum.
Mat3 free_turn(const Mat3& inertia, const Vec3& angular_velocity, double dt);

}  // namespace griffith
