#include <gtest/gtest.h>

#include <Eigen/LU>
#include <random>

#include "sim/contact/mass_properties.h"
#include "tests/contact/bodies.h"

namespace griffith {
namespace {

using testing::box_mass;
using testing::box_part;
using testing::box_parts;
using testing::kDt;

/// A tet, a cube, a long box and a thin one.
std::vector<ConvexPart> shapes() {
  return {{Vec3(0.1, 0, -0.05), Vec3(-0.05, 0.1, -0.05), Vec3(-0.05, -0.1, -0.05), Vec3(0, 0, 0.15)},
          box_part(Vec3::Constant(0.15)),
          box_part(Vec3(0.05, 0.05, 0.4)),
          box_part(Vec3(0.3, 0.3, 0.02))};
}

struct Convex {
  ConvexPart corners;
  RigidMass mass;
};

Convex centered(const ConvexPart& corners, double mass) {
  const MassProperties solid = mass_properties(convex_hull(corners));
  Convex made{corners, {mass, mass / solid.volume * solid.inertia}};
  for (Vec3& corner : made.corners) corner -= solid.center;
  return made;
}

TEST(MassProperties, BoxesAndTetsHaveTheInertiaOfTheTextbooks) {
  const Vec3 size(0.3, 0.5, 0.7);
  ConvexPart corners = box_part(size);
  for (Vec3& corner : corners) corner += Vec3(1, 2, 3);
  const MassProperties box = mass_properties(convex_hull(corners));
  EXPECT_NEAR(box.volume, size.prod(), 1e-12);
  EXPECT_LT((box.center - Vec3(1, 2, 3)).norm(), 1e-12);
  EXPECT_LT((box.inertia - box_mass(size, size.prod()).inertia).norm(), 1e-12);
  const MassProperties tet =
      mass_properties(convex_hull(std::vector<Vec3>{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}));
  EXPECT_NEAR(tet.volume, 1.0 / 6, 1e-12);
  EXPECT_LT((tet.center - Vec3::Constant(0.25)).norm(), 1e-12);
  EXPECT_NEAR(tet.inertia(0, 0), 1.0 / 80, 1e-12);   // 2 (1/60 − 1/6 · 1/16)
  EXPECT_NEAR(tet.inertia(0, 1), 1.0 / 480, 1e-12);  // −(1/120 − 1/6 · 1/16)
}

TEST(MassProperties, PointsInAPlaneHaveNoVolume) {
  EXPECT_FALSE(is_solid(convex_hull(std::vector<Vec3>{})));
  EXPECT_FALSE(is_solid(convex_hull(std::vector<Vec3>{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}})));
  EXPECT_FALSE(is_solid(convex_hull(std::vector<Vec3>{{0, 0, 1}, {1, 0, 1}, {0, 1, 1}, {1, 1, 1}, {.3, .4, 1}})));
  EXPECT_TRUE(is_solid(convex_hull(box_part(Vec3(1e-3, 2e-3, 1e-3)))));
}

TEST(ConvexProjectile, NoneOfThemPassesThroughAThinPlate) {
  std::mt19937 random(5);
  std::uniform_real_distribution<double> uniform(-1, 1);
  for (const ConvexPart& shape : shapes())
    for (int trial = 0; trial < 16; ++trial) {
      ContactWorld world(Vec3::Zero());
      const Vec3 size(3, 3, 0.1);
      const bool kinematic = trial % 2 == 0;
      const ProxyId plate = world.add_proxy(box_parts(size), box_mass(size, 80),
                                            kinematic ? Mobility::kinematic : Mobility::free, {}, {});
      const Convex convex = centered(shape, 1);
      RigidState state;
      state.pose.translation = Vec3(0.5 * uniform(random), 0.5 * uniform(random), 3 + uniform(random));
      state.pose.rotation = Quat(uniform(random), uniform(random), uniform(random), uniform(random)).normalized();
      state.velocity = -100 * Vec3::UnitZ();
      state.angular_velocity = (trial % 3) * 15 * Vec3(uniform(random), uniform(random), uniform(random));
      const ProxyId shot = world.add_convex(convex.corners, convex.mass, state, {});
      Vec3 total = Vec3::Zero();
      for (int i = 0; i < 20; ++i) {
        testing::solve(world, kDt);
        for (const Contact& contact : world.contacts()) total += contact.a == shot ? contact.impulse : -contact.impulse;
        if (!kinematic) testing::advance(world, plate, kDt);
        const Vec3 over = world.state(plate).pose.to_local(world.state(shot).pose.translation);
        if (over.head<2>().cwiseAbs().maxCoeff() > size.x() / 2) break;  // it has slid off
        ASSERT_GT(over.z(), 0) << "corners " << shape.size() << " at " << shape.front().transpose() << ", trial "
                               << trial;
      }
      EXPECT_LT((world.state(shot).velocity - state.velocity - total).norm(), 1e-9);
    }
}

TEST(ConvexProjectile, AFreeSpinKeepsItsAngularMomentum) {
  ContactWorld world(Vec3::Zero());
  const Convex box = centered(box_part(Vec3(0.1, 0.3, 0.6)), 2);
  RigidState state;
  state.angular_velocity = Vec3(3, 8, 1);
  const ProxyId shot = world.add_convex(box.corners, box.mass, state, {});
  const auto momentum = [&] {
    const RigidState now = world.state(shot);
    const Mat3 turn = now.pose.rotation.toRotationMatrix();
    return Vec3(turn * box.mass.inertia * turn.transpose() * now.angular_velocity);
  };
  const Vec3 before = momentum();
  for (int i = 0; i < 300; ++i) testing::solve(world, kDt);
  EXPECT_LT((momentum() - before).norm(), 1e-9 * before.norm());
  EXPECT_GT((world.state(shot).angular_velocity - state.angular_velocity).norm(), 0.1) << "it tumbles";
}

TEST(ConvexProjectile, ABoxComesToRestOnTheGround) {
  ContactWorld world(testing::kGravity);
  world.add_ground(0, {});
  const Convex box = centered(box_part(Vec3(0.2, 0.3, 0.4)), 5);
  RigidState state;
  state.pose.translation = Vec3(0, 1, 0);
  state.pose.rotation = Quat(Eigen::AngleAxisd(0.4, Vec3(1, 2, 3).normalized()));
  const ProxyId shot = world.add_convex(box.corners, box.mass, state, {});
  for (int i = 0; i < 600; ++i) testing::solve(world, kDt);
  EXPECT_LT(world.state(shot).velocity.norm() + world.state(shot).angular_velocity.norm(), 0.02);
  EXPECT_GT(world.state(shot).pose.translation.y(), 0.09);
  EXPECT_LT(world.state(shot).pose.translation.y(), 0.21);
  EXPECT_LT(world.max_penetration(), 2e-3);
}

}  // namespace
}  // namespace griffith
