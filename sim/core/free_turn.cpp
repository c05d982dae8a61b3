#include "sim/core/free_turn.h"

#include <Eigen/LU>
#include <cmath>

#include "sim/core/rotation.h"

namespace griffith {
namespace {

/// Turns a little more, across the momentum, so that the energy is `energy` again.
Mat3 with_energy(Mat3 turn, const Mat3& inverse_inertia, const Vec3& momentum, double energy) {
  constexpr int kNewtonSteps = 3;
  for (int i = 0; i < kNewtonSteps; ++i) {
    const Vec3 spin = turn * inverse_inertia * turn.transpose() * momentum;
    const Vec3 slope = momentum.cross(spin);
    const double excess = 0.5 * momentum.dot(spin) - energy;
    if (std::abs(excess) >= 0.1 * slope.norm()) break;  // about a principal axis the energy hardly depends on a turn
    turn = rotation_by(excess / slope.squaredNorm() * slope) * turn;
  }
  return turn;
}

}  // namespace

Mat3 free_turn(const Mat3& inertia, const Vec3& angular_velocity, double dt) {
  constexpr int kIterations = 4;
  constexpr double kLargestTurn = 1;  // [rad] beyond it, the midpoint's iteration does not converge
  const Vec3 momentum = inertia * angular_velocity;
  if (dt * angular_velocity.norm() > kLargestTurn) {
    const Vec3 axis = momentum.normalized();
    return rotation_by(dt * axis.dot(angular_velocity) * axis).toRotationMatrix();
  }
  const Mat3 inverse_inertia = inertia.inverse();
  Vec3 middle = angular_velocity;
  for (int i = 0; i < kIterations; ++i) {
    const Mat3 half = rotation_by(0.5 * dt * middle).toRotationMatrix();
    middle = half * inverse_inertia * half.transpose() * momentum;
  }
  return with_energy(rotation_by(dt * middle).toRotationMatrix(), inverse_inertia, momentum,
                     0.5 * momentum.dot(angular_velocity));
}

}  // namespace griffith
