#include "sim/solver/contact_cone.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>

#include "tests/random_values.h"

namespace griffith {
namespace {

using testing::RandomValues;

TEST(ContactCone, ProjectsOntoTheNearestImpulse) {
  RandomValues random(1);
  for (int i = 0; i < 200; ++i) {
    const double friction = random.uniform(0, 1.5), least = i % 2 == 0 ? 0 : random.uniform(0, 1);
    const Vec3 asked = random.vector();
    const ConeProjection found = project_on_cone(asked, friction, least);
    EXPECT_GE(found.impulse[0], least);
    EXPECT_LE(found.impulse.tail<2>().norm(), friction * found.impulse[0] + 1e-12);
    if (least == 0) {
      EXPECT_NEAR(found.impulse.dot(asked - found.impulse), 0, 1e-12);
      EXPECT_TRUE(project_on_cone(found.impulse * (1 - 1e-12), friction).impulse.isApprox(found.impulse, 1e-9));
    }
    EXPECT_TRUE(project_on_cone(found.impulse, friction, least).impulse.isApprox(found.impulse, 1e-9));
    for (int k = 0; k < 20; ++k) {
      const double normal = random.uniform(least, 2), angle = random.uniform(0, 6.28);
      const Vec3 other = normal * Vec3(1, friction * std::cos(angle), friction * std::sin(angle));
      EXPECT_GE((asked - other).norm(), (asked - found.impulse).norm() - 1e-12);
    }
  }
}

/// Compares the derivative of a function from asked to found impulses with its difference quotient along a direction.
void expect_derivative(const std::function<ConeProjection(const Vec3&)>& project, const Vec3& asked,
                       const Vec3& direction) {
  constexpr double kStep = 1e-7;
  const ConeProjection found = project(asked);
  const Vec3 quotient =
      (project(asked + kStep * direction).impulse - project(asked - kStep * direction).impulse) / (2 * kStep);
  EXPECT_LT((quotient - found.derivative * direction).norm(), 1e-5);
  EXPECT_TRUE(found.derivative.isApprox(found.derivative.transpose()));
}

TEST(ContactCone, DerivativeIsTheDifferenceQuotient) {
  RandomValues random(2);
  for (int i = 0; i < 200; ++i) {
    const double friction = random.uniform(0.1, 1.5), least = i % 2 == 0 ? 0 : random.uniform(0, 1);
    const Vec3 asked = random.vector();
    expect_derivative([&](const Vec3& impulse) { return project_on_cone(impulse, friction, least); }, asked,
                      random.direction());
  }
}

TEST(Bond, DerivativeIsTheDifferenceQuotient) {
  RandomValues random(5);
  for (int i = 0; i < 200; ++i) {
    const double slack = random.uniform(0, 0.8), strength = random.uniform(0.05, 0.8);
    const Vec3 asked = random.vector();
    expect_derivative([&](const Vec3& impulse) { return hold_back(impulse, slack, strength); }, asked,
                      random.direction());
  }
}

TEST(ContactCone, OnlyWhatPushesWithinTheConeSticks) {
  EXPECT_TRUE(sticks(Vec3(1, 0.3, -0.3), 0.5));
  EXPECT_FALSE(sticks(Vec3(1, 0.4, -0.4), 0.5));
  EXPECT_FALSE(sticks(Vec3(1, 0.3, -0.4), 0.5)) << "on the cone";
  EXPECT_FALSE(sticks(Vec3::Zero(), 0.5));
  EXPECT_FALSE(sticks(Vec3(-1, 0, 0), 0.5));
}

}  // namespace
}  // namespace griffith
