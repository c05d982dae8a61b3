// Projectiles in flight beside other objects.
#include <gtest/gtest.h>

#include "sim/world/world.h"
#include "tests/random_values.h"

namespace griffith {
namespace {

using testing::RandomValues;

/// A ball that passes a spinning chip of glass, weightless and without friction.
Scene pass_of_chip(RandomValues& random) {
  Scene scene;
  scene.gravity.setZero();
  scene.ground.reset();
  scene.simulation.time_step = 1.0 / 60;
  scene.simulation.fracture = false;
  BodyDescription& chip = scene.bodies.emplace_back();
  chip.shape = BoxShape{Vec3(0.08, 0.05, 0.006), Vec3(0.04, 0.05, 0.006)};
  chip.material.young_modulus = 70e9;
  chip.material.friction = 0;
  chip.angular_velocity = random.vector(100);
  chip.velocity = Vec3(0, 0, random.uniform(-6, 6));
  ProjectileBurst& ball = scene.projectiles.emplace_back();
  ball.position = Vec3(random.uniform(-0.05, 0.05), random.uniform(-0.05, 0.05), 0.1);
  ball.direction = -Vec3::UnitZ();
  ball.speed = 15;
  ball.mass = 0.5;
  ball.radius = 0.025;
  ball.friction = 0;
  return scene;
}

TEST(ProjectileFlight, IsStraightBesideWhatSpins) {
  RandomValues random(5);
  int flights = 0;
  for (int pass = 0; pass < 200; ++pass) {
    const Scene scene = pass_of_chip(random);
    World world(scene);
    world.step();
    for (int step = 0; step < 5; ++step) {
      const ProjectileView before = world.frame().projectiles[0];
      world.step();
      const ProjectileView after = world.frame().projectiles[0];
      if (after.velocity != before.velocity || !world.frame().contacts.empty()) continue;
      ++flights;
      const Vec3 displacement = after.position - before.position;
      EXPECT_LT((displacement - scene.simulation.time_step * after.velocity).norm(), 1e-9) << "pass " << pass;
    }
  }
  EXPECT_GT(flights, 800);
}

}  // namespace
}  // namespace griffith
