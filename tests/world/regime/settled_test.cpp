#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "sim/world/world.h"
#include "tests/world/measures.h"
#include "tests/world/scenes.h"

namespace griffith {
namespace {

using testing::brick;
using testing::largest_stress;
using testing::sum_of_reactions;

/// A slab of brick that its foot holds.
Scene standing_slab() {
  Scene scene;
  scene.bodies = {testing::wall(Vec3(0.5, 1, 0.25), 0.25, brick(2))};
  return scene;
}

void step_until(World& world, double time) {
  while (world.frame().time < time - 1e-9) world.step();
}

TEST(Settled, AHeldSlabSleepsUnderItsWeightWithItsStress) {
  World world(standing_slab());
  const double stress = largest_stress(world.frame()), weight = 9.81 * world.frame().bodies[0].mass;
  ASSERT_GT(stress, 1e4);
  step_until(world, 1);
  ASSERT_TRUE(world.frame().bodies[0].asleep);
  EXPECT_TRUE(world.frame().bodies[0].supported);
  EXPECT_FALSE(world.frame().bodies[0].rigid);
  const std::uint64_t state = world.state_hash();
  const double utilization = world.frame().report.peak_utilization;
  step_until(world, 2);
  EXPECT_EQ(world.state_hash(), state);
  EXPECT_EQ(world.frame().report.solver_iterations, 0);
  EXPECT_EQ(world.frame().report.peak_utilization, utilization);
  EXPECT_NEAR(largest_stress(world.frame()), stress, 1e-3 * stress);
  EXPECT_LT((sum_of_reactions(world.frame()) - Vec3(0, weight, 0)).norm(), 1e-3 * weight);
}

/// The slab under a load too small to matter, which keeps it awake.
Scene kept_awake(Scene scene) {
  Load load;
  load.region = HalfSpaceRegion{Vec3(0, 0.45, 0), Vec3::UnitY()};
  load.force = Vec3(0, -1e-9, 0);
  scene.bodies[0].loads = {load};
  return scene;
}

/// With a ball that hits its upper half after a second and a half.
Scene shot_slab(double speed) {
  Scene scene = standing_slab();
  ProjectileBurst shot;
  shot.start = 1.5;
  shot.position = Vec3(0, 0.8, 0.6);
  shot.radius = 0.1;
  shot.mass = 10;
  shot.speed = speed;
  scene.projectiles = {shot};
  return scene;
}

TEST(Settled, AShotStrikesASleeperAsItStrikesWhatIsAwake) {
  for (const double speed : {1.0, 40.0}) {
    World sleeper(shot_slab(speed)), awake(kept_awake(shot_slab(speed)));
    step_until(sleeper, 1.5), step_until(awake, 1.5);
    ASSERT_TRUE(sleeper.frame().bodies[0].asleep);
    ASSERT_FALSE(awake.frame().bodies[0].asleep);
    step_until(sleeper, 1.7), step_until(awake, 1.7);
    const Vec3 expected = awake.frame().projectiles[0].velocity;
    EXPECT_LT((sleeper.frame().projectiles[0].velocity - expected).norm(), 0.02 * (expected.norm() + speed)) << speed;
    EXPECT_EQ(awake.frame().crack_events.empty(), speed < 2);
    EXPECT_NEAR(sleeper.frame().bodies.size(), awake.frame().bodies.size(), 0.1 * awake.frame().bodies.size()) << speed;
    EXPECT_EQ(sleeper.frame().crack_events.empty(), speed < 2);
  }
}

TEST(Settled, WhatIsSetDownOnASleeperLoadsIt) {
  Scene scene = standing_slab();
  ProjectileBurst block;
  block.start = 1.5;
  block.position = Vec3(0, 1.1005, 0);
  block.shape = BoxProjectile{Vec3(0.2, 0.2, 0.2)};
  block.speed = 0;
  block.mass = 400;
  scene.projectiles = {block};
  World world(scene);
  step_until(world, 1.5);
  ASSERT_TRUE(world.frame().bodies[0].asleep);
  const double before = sum_of_reactions(world.frame()).y();
  step_until(world, 4.5);
  EXPECT_TRUE(world.frame().bodies[0].asleep) << "it comes to rest again";
  EXPECT_NEAR(sum_of_reactions(world.frame()).y() - before, 400 * 9.81, 0.02 * 400 * 9.81);
}

TEST(Settled, ALoadToComeKeepsABodyAwake) {
  Scene scene = standing_slab();
  Load push;
  push.region = HalfSpaceRegion{Vec3(0, 0.45, 0), Vec3::UnitY()};
  push.force = Vec3(0, 0, 1000);
  scene.bodies[0].loads = {push};
  World from_start(scene);
  scene.bodies[0].loads[0].start = 2;
  World later(scene);
  step_until(from_start, 4), step_until(later, 4);
  EXPECT_GT(largest_stress(later.frame()), 5e4);
  EXPECT_NEAR(largest_stress(later.frame()), largest_stress(from_start.frame()),
              0.01 * largest_stress(from_start.frame()));
}

TEST(Settled, AMovingSupportKeepsABodyAwake) {
  Scene scene = standing_slab();
  Support pull;
  pull.region = HalfSpaceRegion{Vec3(0, 0.49, 0), Vec3::UnitY()};
  pull.kind = SupportKind::prescribed;
  pull.velocity = Vec3(0, 1e-6, 0);
  scene.bodies[0].supports.push_back(pull);
  World world(scene);
  step_until(world, 2);
  const double moving = largest_stress(world.frame());
  step_until(world, 4);
  EXPECT_FALSE(world.frame().bodies[0].asleep);
  EXPECT_GT(largest_stress(world.frame()) - moving, 0.5 * 2e-6 * brick(1).young_modulus);
}

TEST(Settled, APendulumSwingsOn) {
  Scene scene;
  scene.ground.reset();
  BodyDescription bar = testing::wall(Vec3(0.25, 1, 0.25), 0.25, brick(1000));
  bar.supports = {{SphereRegion{Vec3(0.125, 0.5, 0.125), 0.01}}};
  bar.supports[0].can_tear = false;
  scene.bodies = {bar};
  scene.simulation.fracture = false;
  scene.simulation.static_start = false;
  World world(scene);
  double fastest = 0;
  for (int step = 0; step < 1200; ++step) {
    world.step();
    EXPECT_FALSE(world.frame().bodies[0].asleep) << step;
    if (step > 1000) fastest = std::max(fastest, world.frame().bodies[0].velocity.norm());
  }
  EXPECT_GT(fastest, 1e-3);
}

TEST(Settled, FallingAsleepTakesNextToNoEnergy) {
  World world(standing_slab());
  const Frame start = world.frame();
  const double before = start.totals.kinetic_energy + start.totals.elastic_energy;
  step_until(world, 1.5);
  EXPECT_NEAR(world.frame().totals.kinetic_energy + world.frame().totals.elastic_energy, before, 1e-2 * before);
  EXPECT_LT(std::abs(world.frame().energy.regime_change), 1e-2 * before);
}

}  // namespace
}  // namespace griffith
