#include "sim/solver/whole_motion.h"

#include <Eigen/LU>
#include <utility>

#include "sim/core/rotation.h"

namespace griffith {
namespace {

/// Arms and masses of a motion about a place.
WholeMotion motion_about(const Vec3& place, NodeVectors places, Eigen::VectorXd masses) {
  WholeMotion whole;
  whole.arms = std::move(places);
  whole.masses = std::move(masses);
  whole.arms.leftCols(whole.masses.size()).colwise() -= place;
  return whole;
}

Mat3 inertia_of(const WholeMotion& whole) {
  Mat3 inertia = Mat3::Zero();
  for (Eigen::Index i = 0; i < whole.masses.size(); ++i) {
    const Mat3 arm = cross_matrix(whole.arms.col(i));
    inertia -= whole.masses[i] * arm * arm;
  }
  return inertia;
}

}  // namespace

WholeMotion free_motion(NodeVectors places, Eigen::VectorXd masses) {
  const Vec3 center = places.leftCols(masses.size()) * masses / masses.sum();
  WholeMotion whole = motion_about(center, std::move(places), std::move(masses));
  whole.inverse_mass = 1 / whole.masses.sum();
  whole.inverse_inertia = inertia_of(whole).inverse();
  return whole;
}

WholeMotion swinging_motion(NodeVectors places, Eigen::VectorXd masses, const Pivot& pivot) {
  WholeMotion whole = motion_about(pivot.place, std::move(places), std::move(masses));
  whole.inverse_inertia = inverse_inertia_about(pivot, inertia_of(whole));
  return whole;
}

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
