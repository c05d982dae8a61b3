// The motion of free tops against its closed forms and invariants.

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <cmath>
#include <numbers>
#include <random>

#include "sim/core/rotation.h"

namespace griffith {
namespace {

/// A free top, turned step by step as a body is.
struct Top {
  Mat3 inertia;   ///< at first [kg·m²]
  Vec3 momentum;  ///< [N·m·s]
  Mat3 turned = Mat3::Identity();

  Top(const Mat3& at_first, const Vec3& spin) : inertia(at_first), momentum(at_first * spin) {}
  Mat3 inertia_now() const { return turned * inertia * turned.transpose(); }
  Vec3 spin() const { return inertia_now().inverse() * momentum; }
  double energy() const { return 0.5 * momentum.dot(spin()); }
  void run(double duration, int steps) {
    for (int i = 0; i < steps; ++i) turned = free_turn(inertia_now(), spin(), duration / steps) * turned;
  }
};

const Vec3 kShapes[] = {Vec3(1, 1, 1), Vec3(1, 1, 0.01), Vec3(1, 1, 1.99), Vec3(2, 2, 3), Vec3(1, 2.5, 3)};

TEST(FreeTurn, KeepsMomentumAndEnergyHoweverFastTheSpin) {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> uniform(-1, 1);
  for (const Vec3& shape : kShapes)
    for (const double angle : {1e-9, 1e-3, 0.1, 0.99, 3.0, 40.0, 2e4}) {
      const Mat3 axes = Quat(uniform(random), uniform(random), uniform(random), 1).normalized().toRotationMatrix();
      const Vec3 spin = Vec3(uniform(random), uniform(random), uniform(random)).normalized() * angle;
      Top top(axes * shape.asDiagonal() * axes.transpose(), spin);
      const double energy = top.energy();
      for (int step = 0; step < 20; ++step) {
        top.run(1, 1);
        ASSERT_NEAR(top.energy(), energy, 1e-11 * energy) << shape.transpose() << ", a turn of " << angle;
      }
    }
}

TEST(FreeTurn, WhatDoesNotSpinStaysAsItIs) {
  for (const Vec3& shape : kShapes) {
    Top top(shape.asDiagonal(), Vec3::Zero());
    top.run(1, 1);
    EXPECT_EQ(top.turned, Mat3(Mat3::Identity()));
    Top still(shape.asDiagonal(), Vec3(1, -2, 3) * 1e-17);  // as rounding leaves it
    still.run(1, 1);
    EXPECT_LT((still.turned - Mat3::Identity()).norm(), 1e-15);
  }
}

TEST(FreeTurn, AboutAPrincipalAxisIsSteady) {
  for (const Vec3& shape : kShapes)
    for (int axis = 0; axis < 3; ++axis)
      for (const double angle : {1e-3, 1.0, 30.0}) {
        if (axis == 1 && shape[0] < shape[1] && shape[1] < shape[2] && angle > 1) continue;  // not a stable one
        Top top(shape.asDiagonal(), angle * Vec3::Unit(axis));
        top.run(1, 1);
        const Mat3 expected = Eigen::AngleAxisd(angle, Vec3::Unit(axis)).toRotationMatrix();
        EXPECT_LT((top.turned - expected).norm(), 1e-11) << shape.transpose() << ", axis " << axis;
      }
}

// A symmetric top turns about its axis at (1 - I₃/I₁) ω₃, and that about the momentum at |L|/I₁ (Euler).
TEST(FreeTurn, IsThatOfASymmetricTop) {
  for (const Vec3& shape : {Vec3(2, 2, 3), Vec3(1, 1, 0.01), Vec3(1, 1, 1.99)})
    for (const double speed : {0.1, 1.0, 10.0, 60.0})
      for (const int steps : {15, 60, 1000}) {
        const Vec3 spin = speed * Vec3(1, 0, 2);
        Top top(shape.asDiagonal(), spin);
        top.run(1, steps);
        const Mat3 expected = (Eigen::AngleAxisd(top.momentum.norm() / shape[0], top.momentum.normalized()) *
                               Eigen::AngleAxisd((1 - shape[2] / shape[0]) * spin[2], Vec3::UnitZ()))
                                  .toRotationMatrix();
        EXPECT_LT((top.turned - expected).norm(), 2e-7 * (1 + speed)) << shape.transpose() << ", " << speed << " rad/s";
      }
}

// A body that spins about its middle axis, not quite, turns over and over. Its spin returns after 4 K(k)/λ, which
// Jacobi's elliptic functions tell (Landau and Lifshitz, Mechanics, § 37).
TEST(FreeTurn, TurnsOverAboutTheMiddleAxisAsJacobisFunctionsSay) {
  const Vec3 shape(1, 2, 2.5);
  for (const double speed : {1.0, 20.0}) {
    const Vec3 spin = speed * Vec3(0.02, 1, 0.05);
    const Vec3 momentum = shape.cwiseProduct(spin);
    const double twice_energy = momentum.dot(spin), square = momentum.squaredNorm();
    ASSERT_GT(square, twice_energy * shape[1]);
    const double rate = std::sqrt((shape[2] - shape[1]) * (square - twice_energy * shape[0]) / shape.prod());
    const double modulus = std::sqrt((shape[1] - shape[0]) * (twice_energy * shape[2] - square) /
                                     ((shape[2] - shape[1]) * (square - twice_energy * shape[0])));
    const double period = 4 * std::comp_ellint_1(modulus) / rate;
    Top top(shape.asDiagonal(), spin);
    const auto own_spin = [&] { return Vec3(top.turned.transpose() * top.spin()); };
    top.run(period / 2, 400);
    EXPECT_LT((own_spin() - Vec3(-spin[0], -spin[1], spin[2])).norm(), 1e-5 * speed);
    top.run(period / 2, 400);
    EXPECT_LT((own_spin() - spin).norm(), 1e-5 * speed);
    EXPECT_LT((top.turned * Vec3(momentum / momentum.norm()) - momentum / momentum.norm()).norm(), 1e-5);
  }
}

}  // namespace
}  // namespace griffith
