#include "sim/solver/rigid_motion.h"

#include <Eigen/LU>

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

}  // namespace griffith
