#include "sim/solver/pivot.h"

#include <Eigen/Eigenvalues>
#include <algorithm>

#include "sim/core/dense_algebra.h"
#include "sim/core/rotation.h"
#include "sim/solver/rigid_motion.h"

namespace griffith {
namespace {

/// Square of the share of the size by which a free motion may move what is held.
constexpr double kStill = 1e-9;

}  // namespace

std::optional<Pivot> pivot_of(std::span<const NodeId> supports, std::span<const NodeConstraint> constraints,
                              std::span<const Vec3> positions) {
  Pivot pivot;
  int held = 0;
  for (NodeId node : supports) {
    if (!constraints[node].velocity.isZero(0)) return std::nullopt;
    if (!constraints[node].is_held()) continue;
    pivot.place += positions[node];
    ++held;
  }
  if (held == 0) return std::nullopt;
  pivot.place /= held;
  Mat3 resistance = Mat3::Zero();  // of the supports against turns: the sum of (blocked part of ω × arm)²
  double largest = 0;
  for (NodeId node : supports) {
    const Mat3 arm = cross_matrix(positions[node] - pivot.place);
    resistance += arm.transpose() * (Mat3::Identity() - constraints[node].allowed) * arm;
    largest = std::max(largest, (positions[node] - pivot.place).squaredNorm());
  }
  const Eigen::SelfAdjointEigenSolver<Mat3> eigen(resistance);
  const auto free_axes = (eigen.eigenvalues().array() <= kStill * largest).count();
  if (free_axes != 1 && free_axes != 3) return std::nullopt;
  pivot.axes = eigen.eigenvectors().leftCols(free_axes);
  return pivot;
}

int count_free_motions(std::span<const NodeId> supports, std::span<const NodeConstraint> constraints,
                       std::span<const Vec3> positions) {
  using Motions = Eigen::Matrix<double, 6, 6>;
  if (supports.empty()) return 6;
  Vec3 center = Vec3::Zero();
  for (const NodeId node : supports) center += positions[node] / static_cast<double>(supports.size());
  double size = 0;
  for (const NodeId node : supports) size = std::max(size, (positions[node] - center).norm());
  const double per_length = size > 0 ? 1 / size : 0;
  Motions resistance = Motions::Zero();  // sum of (blocked part of v + ω × arm)²
  for (const NodeId node : supports) {
    Eigen::Matrix<double, 3, 6> velocity;
    velocity << Mat3::Identity(), -per_length * cross_matrix(positions[node] - center);
    resistance += velocity.transpose() * (Mat3::Identity() - constraints[node].allowed) * velocity;
  }
  const Eigen::SelfAdjointEigenSolver<Motions> eigen(resistance, Eigen::EigenvaluesOnly);
  return static_cast<int>((eigen.eigenvalues().array() <= kStill).count());
}

Pivot::Square inverse_inertia_on_axes(const Pivot& pivot, const Mat3& inertia) {
  return dense_inverse(pivot.axes.transpose() * inertia * pivot.axes);
}

Mat3 inverse_inertia_about(const Pivot& pivot, const Mat3& inertia) {
  return pivot.axes * inverse_inertia_on_axes(pivot, inertia) * pivot.axes.transpose();
}

Vec3 common_velocity(std::span<const NodeId> supports, std::span<const NodeConstraint> constraints) {
  Mat3 blocked = Mat3::Zero();
  Vec3 known = Vec3::Zero();
  for (const NodeId node : supports) {
    blocked += Mat3::Identity() - constraints[node].allowed;
    known += constraints[node].velocity;
  }
  if (known.isZero(0)) return known;
  return least_squares(blocked, known);
}

Vec3 spin_about(const Pivot& pivot, const Mat3& inertia, const Vec3& momentum) {
  return pivot.axes * (inverse_inertia_on_axes(pivot, inertia) * (pivot.axes.transpose() * momentum));
}

Turning turning_about(const Pivot& pivot, const NodeVectors& positions, const NodeVectors& velocities,
                      const Eigen::VectorXd& masses) {
  Turning turning;
  for (Eigen::Index node = 0; node < masses.size(); ++node) {
    const Vec3 arm = positions.col(node) - pivot.place;
    turning.inertia += point_inertia(masses[node], arm);
    turning.momentum += masses[node] * arm.cross(velocities.col(node));
  }
  turning.spin = spin_about(pivot, turning.inertia, turning.momentum);
  return turning;
}

Vec3 swing_acceleration(const Pivot& pivot, const NodeVectors& positions, const Eigen::VectorXd& masses,
                        const NodeVectors& forces, const Vec3& half_turn) {
  const Mat3 turn = rotation_by(half_turn).toRotationMatrix();
  Mat3 inertia = Mat3::Zero();
  Vec3 torque = Vec3::Zero();
  for (Eigen::Index node = 0; node < masses.size(); ++node) {
    const Vec3 arm = positions.col(node) - pivot.place;
    inertia += point_inertia(masses[node], arm);
    torque += (turn * arm).cross(forces.col(node));
  }
  return spin_about(pivot, inertia, torque);
}

Vec3 acceleration_gained_halfway(const Pivot& pivot, const NodeVectors& positions, const NodeVectors& velocities,
                                 const Eigen::VectorXd& masses, const NodeVectors& forces, double dt) {
  const Vec3 half_turn = 0.5 * dt * turning_about(pivot, positions, velocities, masses).spin;
  return swing_acceleration(pivot, positions, masses, forces, half_turn) -
         swing_acceleration(pivot, positions, masses, forces, Vec3::Zero());
}

}  // namespace griffith
