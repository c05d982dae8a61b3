#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "sim/world/world.h"
#include "tests/world/scenes.h"

namespace griffith {
namespace {

using testing::brick;

BodyDescription block(const std::string& name, const Vec3& size, const Vec3& position) {
  BodyDescription body;
  body.name = name;
  body.shape = BoxShape{size, size, BoxPattern::five_tet};
  body.position = position;
  body.material = brick(1);
  return body;
}

Scene stack_of_blocks(int count) {
  Scene scene;
  for (int i = 0; i < count; ++i)
    scene.bodies.push_back(block("block " + std::to_string(i), Vec3(0.4, 0.2, 0.3), Vec3(0, 0.1 + 0.2 * i, 0)));
  return scene;
}

/// Steps on; the largest distance that a node has moved.
double creep(World& world, int steps) {
  const std::vector<Vec3> before(world.frame().positions.begin(), world.frame().positions.end());
  for (int step = 0; step < steps; ++step) world.step();
  double moved = 0;
  for (std::size_t i = 0; i < before.size(); ++i)
    moved = std::max(moved, (before[i] - world.frame().positions[i]).norm());
  return moved;
}

TEST(Rest, AStackOfTenBrittleBlocksStandsAndSleeps) {
  World world(stack_of_blocks(10));
  EXPECT_LT(creep(world, 240), 1e-3);
  EXPECT_EQ(world.frame().report.sleeping_bodies, 10);
  EXPECT_EQ(creep(world, 7200), 0);
  EXPECT_EQ(world.frame().bodies.size(), 10u);
}

TEST(Rest, AHeapOfBlocksSleepsWithinFiveSecondsAndDoesNotCreep) {
  Scene scene;
  std::mt19937 random(2);
  std::uniform_real_distribution<double> uniform(-1, 1);
  for (int i = 0; i < 40; ++i) {
    scene.bodies.push_back(block("block " + std::to_string(i), Vec3(0.1, 0.08, 0.12),
                                 Vec3(0.15 * uniform(random), 0.2 + 0.12 * i / 2.0, 0.15 * uniform(random))));
    scene.bodies.back().rotation_degrees = 90 * Vec3(uniform(random), uniform(random), uniform(random));
  }
  World world(scene);
  for (int step = 0; step < 780; ++step) world.step();  // the last block falls from 2.5 m
  EXPECT_EQ(world.frame().report.sleeping_bodies, static_cast<int>(world.frame().bodies.size()));
  EXPECT_EQ(creep(world, 7200), 0);
}

TEST(Rest, AShotWakesWhatItHits) {
  World world(stack_of_blocks(3));
  for (int step = 0; step < 240; ++step) world.step();
  ASSERT_EQ(world.frame().report.sleeping_bodies, 3);
  ProjectileBurst shot;
  shot.position = Vec3(0, 0.3, 0.5);  // near, so that it hits before it falls
  shot.speed = 10;
  shot.mass = 5;
  shot.radius = 0.05;
  world.fire(shot);
  for (int step = 0; step < 60; ++step) world.step();
  EXPECT_LT(world.frame().bodies[1].center_of_mass.z(), -5e-3);
}

}  // namespace
}  // namespace griffith
