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
    motion.inertia += point_inertia(masses[node], arm);
    angular_momentum += masses[node] * arm.cross(velocities.col(node) - motion.velocity);
  }
  motion.angular_velocity = motion.inertia.inverse() * angular_momentum;
  return motion;
}

RigidMotion joined_motion(const RigidMotion& a, const RigidMotion& b) {
  RigidMotion motion;
  motion.mass = a.mass + b.mass;
  motion.center = (a.mass * a.center + b.mass * b.center) / motion.mass;
  motion.velocity = (a.mass * a.velocity + b.mass * b.velocity) / motion.mass;
  Vec3 angular_momentum = Vec3::Zero();
  for (const RigidMotion* part : {&a, &b}) {
    const Vec3 arm = part->center - motion.center;
    motion.inertia += part->inertia + point_inertia(part->mass, arm);
    angular_momentum +=
        part->inertia * part->angular_velocity + part->mass * arm.cross(part->velocity - motion.velocity);
  }
  motion.angular_velocity = motion.inertia.inverse() * angular_momentum;
  return motion;
}

}  // namespace griffith
