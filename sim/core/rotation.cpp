#include "sim/core/rotation.h"

#include <Eigen/LU>
#include <algorithm>
#include <array>
#include <cmath>

namespace griffith {
namespace {

/// Euler's equations of a free top in body axes: its angular momentum l changes by l × J⁻¹l. The implicit midpoint rule
/// keeps |l|² and the energy ½ l·J⁻¹l, since both are quadratic.
class FreeTop {
 public:
  FreeTop(const Mat3& inertia, const Vec3& angular_velocity)
      : inverse_inertia_(inertia.inverse()), momentum_(inertia * angular_velocity) {}

  Vec3 spin() const { return inverse_inertia_ * momentum_; }
  const Mat3& turn() const { return turn_; }

  /// Advances the top by a duration [s] in which it rotates by less than a radian.
  void advance(double duration) {
    const Vec3 mean_spin = inverse_inertia_ * mean_momentum(duration);
    // Rotates by the full angle at this spin; the rule itself would rotate by 2 atan(½ duration |spin|).
    const Mat3 turn = rotation_by(duration * mean_spin).toRotationMatrix();
    momentum_ = turn.transpose() * momentum_;
    turn_ = turn_ * turn;
  }

 private:
  /// Returns the mean m of the momentum before and after a substep, m = l + τ/2 m × J⁻¹m, by Newton's method. τ is the
  /// time in which the midpoint rule rotates by the angle of the spin in `duration`.
  Vec3 mean_momentum(double duration) const {
    constexpr int kMaxIterations = 12;
    Vec3 mean = momentum_;
    for (int i = 0; i < kMaxIterations; ++i) {
      const Vec3 mean_spin = inverse_inertia_ * mean;
      const double speed = mean_spin.norm();
      const double half = speed > 0 ? std::tan(0.5 * duration * speed) / speed : 0;
      const Mat3 slope = Mat3::Identity() + half * (cross_matrix(mean_spin) - cross_matrix(mean) * inverse_inertia_);
      const Vec3 change = slope.inverse() * (momentum_ + half * mean.cross(mean_spin) - mean);
      mean += change;
      if (!(change.norm() > 1e-15 * momentum_.norm())) break;
    }
    return mean;
  }

  Mat3 inverse_inertia_;  ///< in the initial axes
  Vec3 momentum_;
  Mat3 turn_ = Mat3::Identity();
};

/// Five substeps that make a symmetric rule of second order one of fourth (Suzuki 1990).
void advance_by_fourth_order(FreeTop& top, double duration) {
  const double outer = 1 / (4 - std::cbrt(4.0));
  for (const double share : {outer, outer, 1 - 4 * outer, outer, outer}) top.advance(share * duration);
}

/// Three, which do the same with a larger error (Yoshida 1990).
void advance_by_three_substeps(FreeTop& top, double duration) {
  const double outer = 1 / (2 - std::cbrt(2.0));
  for (const double share : {outer, 1 - 2 * outer, outer}) top.advance(share * duration);
}

/// Returns a rotation about the angular momentum. It keeps momentum and energy, but not the precession.
Mat3 turn_about_momentum(const Mat3& inertia, const Vec3& angular_velocity, double dt) {
  const Vec3 axis = (inertia * angular_velocity).normalized();
  return rotation_by(dt * axis.dot(angular_velocity) * axis).toRotationMatrix();
}

}  // namespace

Mat3 free_turn(const Mat3& inertia, const Vec3& angular_velocity, double dt) {
  constexpr double kTurn = 0.125;                     // [rad] per substep, with an error of some 1e-8
  constexpr double kThreeDo = 0.05, kOneDoes = 5e-4;  // [rad] with no larger error
  constexpr double kLargestTurn = 100;  // [rad] faster rotations are not resolved by eye, and would take too long
  if (angular_velocity.isZero(0)) return Mat3::Identity();
  FreeTop top(inertia, angular_velocity);
  for (double left = dt; left > 0;) {
    // Thin pieces may come to spin much faster about their axis of least inertia.
    const double turn_left = left * top.spin().norm();
    if (!(turn_left < kLargestTurn)) return turn_about_momentum(inertia, angular_velocity, dt);
    if (turn_left < kOneDoes) {
      top.advance(left);
      break;
    }
    if (turn_left < kThreeDo) {
      advance_by_three_substeps(top, left);
      break;
    }
    const double count = std::max(1.0, std::ceil(turn_left / kTurn));
    advance_by_fourth_order(top, left / count);
    left = count > 1 ? left - left / count : 0;
  }
  return top.turn();
}

}  // namespace griffith
