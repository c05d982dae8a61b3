// Projectiles in flight beside other objects.
#include <gtest/gtest.h>

#include "sim/world/world.h"
#include "tests/random_values.h"
#include "tests/world/scenes.h"

namespace griffith {
namespace {

using testing::RandomValues;
using testing::weightless_scene;

/// A ball that flies along −z without friction.
ProjectileBurst frictionless_ball(const Vec3& position, double speed, double mass, double radius) {
  ProjectileBurst shot;
  shot.position = position;
  shot.direction = -Vec3::UnitZ();
  shot.speed = speed;
  shot.mass = mass;
  shot.radius = radius;
  shot.friction = 0;
  return shot;
}

/// A ball that passes a spinning chip of glass, weightless and without friction.
Scene pass_of_chip(RandomValues& random) {
  Scene scene = weightless_scene(60);
  BodyDescription& chip = scene.bodies.emplace_back();
  chip.shape = BoxShape{Vec3(0.08, 0.05, 0.006), Vec3(0.04, 0.05, 0.006)};
  chip.material.young_modulus = 70e9;
  chip.material.friction = 0;
  chip.angular_velocity = random.vector(100);
  chip.velocity = Vec3(0, 0, random.uniform(-6, 6));
  const Vec3 place(random.uniform(-0.05, 0.05), random.uniform(-0.05, 0.05), 0.1);
  scene.projectiles = {frictionless_ball(place, 15, 0.5, 0.025)};
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

/// A heavy ball that runs into a row of free cubes, weightless and without friction.
Scene row_of_cubes(double rate) {
  Scene scene = weightless_scene(rate);
  for (int i = 0; i < 3; ++i) {
    BodyDescription& cube = scene.bodies.emplace_back();
    cube.name = "cube " + std::to_string(i);
    cube.shape = BoxShape{Vec3::Constant(0.1), Vec3::Constant(0.1)};
    cube.position = Vec3(0.01 * i, 0.02, -0.3 - 0.5 * i);
    cube.material.young_modulus = 50e9;
    cube.material.density = 2650;
    cube.material.friction = 0;
  }
  scene.projectiles = {frictionless_ball(Vec3(0, 0, 0.3), 20, 20, 0.085)};
  return scene;
}

/// An impact takes no time: what is struck late in a step is carried along for the rest of it. The center of mass of
/// all moves evenly, but for what is pushed into the next cube: that takes a tenth of a step at most.
TEST(ProjectileFlight, AHeavyBallDoesNotWaitForWhatItPushes) {
  for (const double rate : {30.0, 60.0, 250.0}) {
    const Scene scene = row_of_cubes(rate);
    World world(scene);
    const double mass = world.frame().totals.mass + scene.projectiles[0].mass;
    const auto moment = [&] {  // mass times position along the flight
      const Frame frame = world.frame();
      double sum = frame.projectiles.empty() ? 20 * 0.3 : 20 * frame.projectiles[0].position.z();
      for (const BodyView& body : frame.bodies) sum += body.mass * body.center_of_mass.z();
      return sum;
    };
    const double start = moment();
    double lost = 0;
    for (int step = 0; step < static_cast<int>(rate / 10); ++step) {
      const double before = step == 0 ? 0.3 : world.frame().projectiles[0].position.z();
      const double speed = step == 0 ? 20 : world.frame().projectiles[0].velocity.norm();
      world.step();
      const ProjectileView now = world.frame().projectiles[0];
      lost += std::max(0.0, std::min(speed, now.velocity.norm()) / rate - (before - now.position.z()));
    }
    EXPECT_LT(lost, 0.02) << rate;
    EXPECT_NEAR((moment() - start) / mass, -20 * 20 / mass * 0.1, 0.1 * 20 / rate) << rate;
  }
}

}  // namespace
}  // namespace griffith
