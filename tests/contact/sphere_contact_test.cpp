#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

#include "tests/contact/bodies.h"
#include "tests/contact/bounces.h"

namespace griffith {
namespace {

using testing::at;
using testing::box_mass;
using testing::box_parts;
using testing::kDt;

constexpr double kTimeTolerance = 1e-5;  // of times [s]

void step(ContactWorld& world, double dt = kDt) { testing::solve(world, dt); }

TEST(SphereContact, FreeFallFollowsTheSemiImplicitRule) {
  const Vec3 gravity(0.3, -9.81, 1.7);
  ContactWorld world(gravity);
  const ProxyId ball = world.add_sphere(0.2, 3, at(Vec3(1, 2, 3), Vec3(4, 5, 6)), {});
  Vec3 position(1, 2, 3), velocity(4, 5, 6);
  for (int i = 0; i < 240; ++i) {
    step(world);
    velocity += kDt * gravity;
    position += kDt * velocity;
  }
  EXPECT_LT((world.state(ball).velocity - velocity).norm(), 1e-12);
  EXPECT_LT((world.state(ball).pose.translation - position).norm(), 1e-11);
}

struct Collision {
  double mass_a, mass_b, speed, offset, friction, restitution;
};

class SphereCollision : public ::testing::TestWithParam<Collision> {};

TEST_P(SphereCollision, ImpulsesAreTheChangesOfMomentumAndTheRestitutionIsKept) {
  const Collision& test = GetParam();
  ContactWorld world(Vec3::Zero());
  const SurfaceProperties surface{test.friction, test.restitution};
  const ProxyId a = world.add_sphere(0.2, test.mass_a, at(Vec3(-1, test.offset, 0), Vec3(test.speed, 0, 0)), surface);
  const ProxyId b = world.add_sphere(0.3, test.mass_b, at(Vec3(1, 0, 0)), surface);
  const Vec3 momentum = test.mass_a * world.state(a).velocity;
  double closing = 0, parting = 0;
  int impacts = 0;
  for (int i = 0; i < 240; ++i) {
    const RigidState before_a = world.state(a), before_b = world.state(b);
    step(world);
    Vec3 impulse_on_a = Vec3::Zero(), impulse_on_b = Vec3::Zero();
    for (const Contact& contact : world.contacts()) {
      const Vec3 on_a = contact.a == a ? contact.impulse : -contact.impulse;
      impulse_on_a += on_a;
      impulse_on_b -= on_a;
      if (contact.impulse.norm() == 0) continue;
      const Vec3 normal = contact.a == a ? contact.normal : Vec3(-contact.normal);
      closing = normal.dot(before_b.velocity - before_a.velocity);
      parting = normal.dot(world.state(a).velocity - world.state(b).velocity);
      ++impacts;
    }
    EXPECT_LT((test.mass_a * (world.state(a).velocity - before_a.velocity) - impulse_on_a).norm(), 1e-9);
    EXPECT_LT((test.mass_b * (world.state(b).velocity - before_b.velocity) - impulse_on_b).norm(), 1e-9);
  }
  EXPECT_EQ(impacts, 1);
  EXPECT_NEAR(parting, test.restitution * closing, 1e-6 * test.speed);
  const Vec3 after = test.mass_a * world.state(a).velocity + test.mass_b * world.state(b).velocity;
  EXPECT_LT((after - momentum).norm(), 1e-9 * momentum.norm());
}

INSTANTIATE_TEST_SUITE_P(Collisions, SphereCollision,
                         ::testing::Values(Collision{1, 1, 2, 0, 0, 1}, Collision{1, 1, 5, 0, 0, 0},
                                           Collision{2, 7, 3, 0.1, 0, 0.5}, Collision{25, 1, 40, 0.2, 0.6, 0.3},
                                           Collision{0.5, 30, 100, -0.3, 1, 0.8}));

TEST(SphereContact, ABounceRisesToTheSquareOfItsRestitutionAndNeverAbove) {
  for (double restitution : {0.5, 0.9, 1.0})
    for (double dt : {1.0 / 30, 1.0 / 60, 1.0 / 120, 1e-3}) {
      ContactWorld world(Vec3(0, -9.81, 0));
      world.add_ground(0, {0.6, restitution});
      const ProxyId ball = world.add_sphere(0.1, 2, at(Vec3(0.3, 1.1, 0)), {0.6, restitution});
      double drop = 1;
      testing::BounceTops tops;
      for (double time = 0; time < 4 && tops.count() < 5; time += dt) {
        testing::solve(world, dt);
        const RigidState& state = world.state(ball);
        const std::optional<double> top = tops.passed(state.pose.translation.y() - 0.1, state.velocity.y() > 0);
        if (!top) continue;
        // In steps, a top lies up to g dt²/8 above that of the parabola.
        ASSERT_LE(*top, restitution * restitution * drop + 9.81 * dt * dt / 8) << "e " << restitution << ", dt " << dt;
        EXPECT_GE(*top, restitution * restitution * drop - 10 * dt * dt - 5 * dt * std::sqrt(drop) * (1 - restitution))
            << "e " << restitution << ", dt " << dt;
        drop = *top;
      }
      EXPECT_GE(tops.count(), 2);
    }
}

TEST(SphereContact, NoneMovesFurtherThanItsSpeedAllows) {
  std::mt19937 random(11);
  std::uniform_real_distribution<double> uniform(-1, 1);
  for (int trial = 0; trial < 40; ++trial) {
    ContactWorld world(Vec3::Zero());
    std::vector<ProxyId> debris;
    for (int i = 0; i < 8; ++i) {
      const Vec3 size(0.05 + 0.3 * std::abs(uniform(random)), 0.4, 0.05);
      RigidState state = at(0.6 * Vec3(uniform(random), uniform(random), uniform(random)));
      state.angular_velocity = 60 * Vec3(uniform(random), uniform(random), uniform(random));
      debris.push_back(world.add_proxy(box_parts(size), box_mass(size, 0.3), Mobility::free, state, {}));
    }
    const ProxyId ball = world.add_sphere(0.1, 5, at(Vec3(0.2 * uniform(random), 0, 2), Vec3(0, 0, -28)), {});
    double way = 0, due = 0;
    for (int i = 0; i < 20; ++i) {
      const RigidState before = world.state(ball);
      world.detect();
      const bool touched = world.max_penetration() > 1e-5;
      world.solve(kDt);
      world.advance(kDt);
      for (ProxyId id : debris) testing::advance(world, id, kDt);
      const RigidState after = world.state(ball);
      const double moved = (after.pose.translation - before.pose.translation).norm();
      if (!touched) {
        const double speed = std::max(before.velocity.norm(), after.velocity.norm());
        EXPECT_LE(moved, speed * kDt * (1 + 1e-6)) << "trial " << trial << ", step " << i;
      }
      way += moved;
      due += after.velocity.norm() * kDt;
    }
    EXPECT_GT(way, 0.6 * due) << "it does not hang in the debris, trial " << trial;
  }
}

TEST(SphereContact, FrictionTurnsASlidingSphereIntoARollingOne) {
  ContactWorld world(Vec3(0, -9.81, 0));
  const SurfaceProperties without_rolling_resistance{0.5, 0, 0};
  world.add_ground(0, without_rolling_resistance);
  const ProxyId ball = world.add_sphere(0.25, 2, at(Vec3(0, 0.25, 0), Vec3(3, 0, 0)), without_rolling_resistance);
  for (int i = 0; i < 120; ++i) step(world);
  // Rolling begins at 5/7 of the speed, whatever the friction.
  EXPECT_NEAR(world.state(ball).velocity.x(), 3 * 5.0 / 7, 1e-3);
  EXPECT_NEAR(world.state(ball).angular_velocity.z(), -3 * 5.0 / 7 / 0.25, 5e-3);
}

TEST(SphereContact, ASphereRestsOnTheGroundWithItsWeightAsImpulse) {
  ContactWorld world(Vec3(0, -9.81, 0));
  const ProxyId ground = world.add_ground(1, {});
  const ProxyId ball = world.add_sphere(0.2, 25, at(Vec3(0, 2, 0)), {});
  for (int i = 0; i < 600; ++i) step(world);
  EXPECT_NEAR(world.state(ball).pose.translation.y(), 1.2, 1e-4);
  EXPECT_LT(world.state(ball).velocity.norm(), 1e-6);
  ASSERT_EQ(world.contacts().size(), 1u);
  const Contact& contact = world.contacts()[0];
  const Vec3 on_ball = contact.a == ball ? contact.impulse : Vec3(-contact.impulse);
  EXPECT_TRUE(contact.a == ground || contact.b == ground);
  EXPECT_LT((on_ball - Vec3(0, 25 * 9.81 * kDt, 0)).norm(), 1e-6);
  EXPECT_LT(world.max_penetration(), 1e-4);
}

TEST(SphereContact, NothingPassesThroughAThinPlate) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> uniform(-1, 1);
  for (int trial = 0; trial < 40; ++trial) {
    ContactWorld world(Vec3::Zero());
    const Vec3 size(2, 2, trial % 2 ? 0.1 : 0.01);
    const bool kinematic = trial % 4 < 2;
    const ProxyId plate =
        world.add_proxy(box_parts(size), box_mass(size, 80), kinematic ? Mobility::kinematic : Mobility::free, {}, {});
    const Vec3 aim(0.5 * uniform(random), 0.5 * uniform(random), 0);
    const Vec3 start = aim + Vec3(0.3 * uniform(random), 0.3 * uniform(random), 3 + uniform(random));
    const double speed = 100;
    const Vec3 velocity = speed * (aim - start).normalized();
    const ProxyId ball = world.add_sphere(0.05, 1, at(start, velocity), {});
    Vec3 total = Vec3::Zero();
    for (int i = 0; i < 30; ++i) {
      testing::solve(world, kDt);
      for (const Contact& contact : world.contacts()) total += contact.a == ball ? contact.impulse : -contact.impulse;
      if (!kinematic) testing::advance(world, plate, kDt);
    }
    const RigidState end = world.state(ball), plate_end = world.state(plate);
    EXPECT_GT((end.pose.translation - plate_end.pose.translation).dot(plate_end.pose.rotation * Vec3::UnitZ()), 0);
    EXPECT_LT((end.velocity - velocity - total).norm(), 1e-9);
    EXPECT_GE(total.z(), kinematic ? -velocity.z() - 0.2 : 1.0);
  }
}

/// Touching one wall of a hollow body does not open the way into its others.
TEST(SphereContact, NothingThatSlidesAlongOneWallEntersTheNext) {
  constexpr double kRadius = 0.1, kWall = 1;
  std::vector<ConvexPart> corner = {testing::box_part(Vec3(4, 0.2, 2)), testing::box_part(Vec3(0.2, 4, 2))};
  for (Vec3& point : corner[0]) point.y() -= 0.1;          // a floor with its top at y = 0
  for (Vec3& point : corner[1]) point.x() += kWall + 0.1;  // a wall from x = kWall on
  for (const double way : {0.02, 0.05, 0.1, 0.15})
    for (const double height : {0.0, 1e-4, 1e-3, 5e-3}) {
      ContactWorld world(Vec3(0, -9.81, 0));
      world.add_proxy(corner, box_mass(Vec3::Ones(), 80), Mobility::kinematic, {}, {0, 0});
      const Vec3 start(kWall - kRadius - way, kRadius + height, 0);
      const ProxyId ball = world.add_sphere(kRadius, 1, at(start, Vec3(20, -2 * height / kDt, 0)), {0, 0});
      for (int i = 0; i < 3; ++i) {
        step(world);
        EXPECT_LT(world.state(ball).pose.translation.x(), kWall - 0.99 * kRadius) << way << " m off, step " << i;
      }
    }
}

TEST(SphereContact, SpheresThatCrossInOneSubstepCollide) {
  ContactWorld world(Vec3::Zero());
  const ProxyId a = world.add_sphere(0.05, 1, at(Vec3(-0.5, 0, 0), Vec3(100, 0, 0)), {0, 1});
  const ProxyId b = world.add_sphere(0.05, 1, at(Vec3(0.5, 0, 0), Vec3(-100, 0, 0)), {0, 1});
  for (int i = 0; i < 4; ++i) step(world);
  EXPECT_NEAR(world.state(a).velocity.x(), -100, 1e-6);
  EXPECT_NEAR(world.state(b).velocity.x(), 100, 1e-6);
}

TEST(SphereContact, AnImpactIsForetold) {
  for (bool approaching : {true, false}) {
    ContactWorld world(Vec3(0, -9.81, 0));
    const Vec3 size(2, 2, 0.1);
    const ProxyId plate = world.add_proxy(box_parts(size), box_mass(size, 80), Mobility::kinematic, {}, {});
    world.set_impact_speed(plate, 10);
    world.add_sphere(0.2, 25, at(Vec3(0, 0, 0.5), Vec3(0, 0, approaching ? -40 : 40)), {});
    world.detect();
    EXPECT_NE(world.expected_impacts(kDt, 1, kTimeTolerance).empty(), approaching);
    EXPECT_TRUE(world.expected_impacts(kDt / 4, 1, kTimeTolerance).empty());  // too far off
    EXPECT_TRUE(world.expected_impacts(kDt, 50, kTimeTolerance).empty());     // too slow
    world.set_impact_speed(plate, 50);
    EXPECT_TRUE(world.expected_impacts(kDt, 1, kTimeTolerance).empty());  // too slow to cause damage
  }
}

TEST(SphereContact, TimeBeforeAnImpactIsThatOfFreeFlight) {
  ContactWorld world(Vec3::Zero());
  const Vec3 size(2, 2, 0.1);
  world.set_impact_speed(world.add_proxy(box_parts(size), box_mass(size, 80), Mobility::kinematic, {}, {}), 10);
  world.add_sphere(0.2, 25, at(Vec3(0, 0, 0.5), Vec3(0, 0, -40)), {});   // 0.25 m off
  world.add_sphere(0.2, 25, at(Vec3(0, 0, -0.6), Vec3(0, 0, 50)), {});   // 0.35 m off
  world.add_sphere(0.2, 25, at(Vec3(0.7, 0, 0.3), Vec3(0, 0, -9)), {});  // too slow to cause damage
  world.detect();
  const auto impacts = world.expected_impacts(kDt, 1, kTimeTolerance);
  ASSERT_EQ(impacts.size(), 2u);
  for (const auto& impact : impacts)
    EXPECT_NEAR(impact.time, impact.approach < 45 ? 0.25 / 40 : 0.35 / 50, 2 * kTimeTolerance) << impact.approach;
  EXPECT_TRUE(world.expected_impacts(0.006, 1, kTimeTolerance).empty());
  EXPECT_TRUE(world.expected_impacts(kDt, 60, kTimeTolerance).empty());
}

TEST(SphereContact, ASpinBringsASphereNoNearer) {
  ContactWorld world(Vec3::Zero());
  world.add_ground(0, {});
  RigidState state = at(Vec3(0, 0.201, 0), Vec3(5, 0.1, 0));
  state.angular_velocity = Vec3(0, 0, -25);
  world.set_impact_speed(world.add_sphere(0.2, 25, state, {}), 1);
  world.detect();
  EXPECT_TRUE(world.expected_impacts(kDt, 0.2, kTimeTolerance).empty());
}

TEST(SphereContact, WhatTurnsFarAwayStopsNothing) {
  ContactWorld world(Vec3::Zero());
  const ProxyId ball = world.add_sphere(0.1, 1, at(Vec3(3, 0, 0), Vec3(0, 1, 0)), {});
  RigidState turning = at(Vec3::Zero());
  turning.angular_velocity = Vec3(0, 0, 3 / kDt);  // nearly half a turn
  const Vec3 size(1, 0.2, 0.2);
  world.add_proxy(box_parts(size), box_mass(size, 1), Mobility::free, turning, {});
  step(world);
  EXPECT_LT((world.state(ball).pose.translation - Vec3(3, kDt, 0)).norm(), 1e-12);
}

TEST(SphereContact, SpheresInsideOneAnotherMeetAlongTheLineOfTheirCenters) {
  for (const double apart : {0.0, 1e-9, 0.01, 0.2, 0.499}) {
    ContactWorld world(Vec3::Zero());
    const Vec3 way = Vec3(1, 2, -2) / 3;
    const ProxyId a = world.add_sphere(0.2, 1, at(Vec3(5, 6, 7) + apart * way), {});
    world.add_sphere(0.3, 1, at(Vec3(5, 6, 7)), {});
    world.detect();
    ASSERT_EQ(world.contacts().size(), 1u) << apart;
    const Contact& contact = world.contacts()[0];
    EXPECT_NEAR(contact.distance, apart - 0.5, 1e-12) << apart;
    EXPECT_NEAR(contact.normal.norm(), 1, 1e-12) << apart;
    if (apart < 1e-6) continue;
    EXPECT_NEAR(contact.normal.dot(contact.a == a ? way : Vec3(-way)), 1, 1e-9) << apart;
  }
}

TEST(SphereContact, RestIsNoImpact) {
  ContactWorld world(Vec3(0, -9.81, 0));
  world.add_ground(0, {});
  world.add_sphere(0.2, 25, at(Vec3(0, 0.2, 0)), {});
  for (int i = 0; i < 20; ++i) {
    EXPECT_TRUE(world.expected_impacts(kDt, 0.5, kTimeTolerance).empty());
    step(world);
  }
}

TEST(SphereContact, NotFinitePlacesAreRefusedInDebugBuilds) {
  ContactWorld world(Vec3::Zero());
  const ProxyId ball = world.add_sphere(0.2, 1, at(Vec3::Zero()), {});
  EXPECT_DEBUG_DEATH(world.set_state(ball, at(Vec3(NAN, 0, 0))), "is_valid");
}

}  // namespace
}  // namespace griffith
