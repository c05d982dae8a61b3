#pragma once

#include "sim/solver/block_sparse_matrix.h"

namespace griffith {

/// Mass, momentum and the rigid motion that carries them, of a set of nodes.
struct RigidMotion {
  double mass = 0;                       ///< [kg]
  Vec3 center = Vec3::Zero();            ///< center of mass [m]
  Mat3 inertia = Mat3::Zero();           ///< inertia about the center, world frame [kg·m²]
  Vec3 velocity = Vec3::Zero();          ///< [m/s]
  Vec3 angular_velocity = Vec3::Zero();  ///< [rad/s]

  bool is_still() const { return velocity.isZero(0) && angular_velocity.isZero(0); }
  Vec3 velocity_at(const Vec3& position) const { return velocity + angular_velocity.cross(position - center); }
};

/// Returns the inertia of a point mass about a point at this arm from it [kg·m²].
inline Mat3 point_inertia(double mass, const Vec3& arm) {
  return mass * (arm.squaredNorm() * Mat3::Identity() - arm * arm.transpose());
}

/// Returns the rigid motion with the linear and angular momentum of these nodes: one column or entry a node [m], [m/s],
/// [kg]. They must not all lie on one line.
RigidMotion rigid_motion(const NodeVectors& positions, const NodeVectors& velocities, const Eigen::VectorXd& masses);

/// Returns the rigid motion of two bodies that have become one, with the momentum of both.
RigidMotion joined_motion(const RigidMotion& a, const RigidMotion& b);

/// Velocities of a point at an arm from the center by the six rigid motions, unit velocities along the axes and unit
/// rotations about them: [I, −[arm]×].
using RigidModes = Eigen::Matrix<double, 3, 6>;
inline RigidModes rigid_modes(const Vec3& arm) {
  RigidModes modes;
  modes << 1, 0, 0, 0, arm.z(), -arm.y(),  //
      0, 1, 0, -arm.z(), 0, arm.x(),       //
      0, 0, 1, arm.y(), -arm.x(), 0;
  return modes;
}

}  // namespace griffith
