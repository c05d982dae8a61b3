#include "sim/solver/whole_motion.h"

namespace griffith {

Vec3 WholeMotion::spin_of(const Eigen::Ref<const NodeVectors>& velocities) const {
  Vec3 momentum = Vec3::Zero();
  for (Eigen::Index i = 0; i < masses.size(); ++i)
    momentum += masses[i] * Vec3(arms.col(i)).cross(Vec3(velocities.col(i)));
  return inverse_inertia * momentum;
}

NodeVectors WholeMotion::part_of(const Eigen::Ref<const NodeVectors>& velocities) const {
  const Vec3 velocity = inverse_mass * (velocities.leftCols(masses.size()) * masses), spin = spin_of(velocities);
  NodeVectors field(3, arms.cols());
  for (Eigen::Index i = 0; i < field.cols(); ++i) field.col(i) = spin.cross(Vec3(arms.col(i)));
  field.leftCols(masses.size()).colwise() += velocity;
  return field;
}

NodeVectors WholeMotion::momentum_of(const Eigen::Ref<const NodeVectors>& impulses) const {
  Vec3 torque = Vec3::Zero();
  for (Eigen::Index i = 0; i < arms.cols(); ++i) torque += Vec3(arms.col(i)).cross(Vec3(impulses.col(i)));
  const Vec3 velocity = inverse_mass * impulses.leftCols(masses.size()).rowwise().sum(),
             spin = inverse_inertia * torque;
  NodeVectors momentum = NodeVectors::Zero(3, arms.cols());
  for (Eigen::Index i = 0; i < masses.size(); ++i)
    momentum.col(i) = masses[i] * (velocity + spin.cross(Vec3(arms.col(i))));
  return momentum;
}

}  // namespace griffith
