#include "sim/solver/rigid_motion.h"

#include <Eigen/LU>

#include "sim/rotation.h"

namespace griffith {
RigidMotion rigid_motion(const NodeVectors& positions, const NodeVectors& velocities, const Eigen::VectorXd& masses) {
  RigidMotion motion;
  motion.mass = masses.sum();
  motion.center = positions * masses / motion.mass;
  motion.velocity = velocities * masses / motion.mass;
  Vec3 angular_momentum = Vec3::Zero();
  for (Eigen::Index node = 0; node < masses.size(); ++node) {
    const Vec3 arm = positions.col(node) - motion.center;
    motion.inertia += masses[node] * (arm.squaredNorm() * Mat3::Identity() - arm * arm.transpose());
    angular_momentum += masses[node] * arm.cross(velocities.col(node) - motion.velocity);
  }
  motion.angular_velocity = motion.inertia.inverse() * angular_momentum;
  return motion;
}

Mat3 turn_step(const RigidMotion& motion, double dt) {
  constexpr int kIterations = 4;
  const Mat3 inverse_inertia = motion.inertia.inverse();
  const Vec3 angular_momentum = motion.inertia * motion.angular_velocity;
  Vec3 middle = motion.angular_velocity;
  for (int i = 0; i < kIterations; ++i) {
    const Mat3 half = rotation_by(0.5 * dt * middle).toRotationMatrix();
    middle = half * inverse_inertia * half.transpose() * angular_momentum;
  }
  return rotation_by(dt * middle).toRotationMatrix();
}

}  // namespace griffith
