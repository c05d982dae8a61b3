#include <gtest/gtest.h>

#include <cmath>
#include <numeric>
#include <string>
#include <vector>

#include "sim/world/world.h"
#include "tests/world/contact/contact_scenes.h"

namespace griffith {
namespace {

/// A free plate in weightless space that a sphere strikes off its middle.
Scene struck_plate(double young_modulus, double time_step, double speed) {
  Scene scene;
  scene.gravity.setZero();
  scene.ground.reset();
  BodyDescription plate;
  plate.shape = BoxShape{Vec3(2, 2, 0.25), Vec3(0.5, 0.5, 0.25), BoxPattern::five_tet};
  plate.material.young_modulus = young_modulus;
  plate.material.tensile_strength = 1e6;
  scene.bodies = {plate};
  ProjectileBurst shot;
  shot.position = Vec3(0.1, 0.1, 1);
  shot.direction = -Vec3::UnitZ();
  shot.speed = speed;
  shot.mass = 5;
  shot.radius = 0.1;
  scene.projectiles = {shot};
  scene.simulation.time_step = time_step;
  return scene;
}

/// A beam of glass, 10 mm thick, on two bearings of steel, and a ball of steel that falls on its middle.
Scene struck_beam(double time_step, double speed) {
  Scene scene;
  scene.simulation.time_step = time_step;
  scene.ground.reset();
  scene.bodies = {testing::box("beam", Vec3(0.4, 0.01, 0.04), Vec3::Zero(), testing::preset("soda_lime_glass"),
                               Vec3(0.02, 0.01, 0.02))};
  for (const double x : {-0.18, 0.18}) {
    scene.bodies.push_back(testing::box("bearing at " + std::to_string(x), Vec3(0.02, 0.02, 0.06), Vec3(x, -0.015, 0),
                                        testing::preset("mild_steel"), Vec3::Constant(0.02)));
    scene.bodies.back().supports = {{HalfSpaceRegion{Vec3(0, -0.005, 0), -Vec3::UnitY()}}};
  }
  ProjectileBurst& ball = scene.projectiles.emplace_back();
  ball.position = Vec3(0, 0.026, 0);
  ball.direction = -Vec3::UnitY();
  ball.speed = speed;
  ball.mass = 0.5;
  ball.radius = 0.02;
  return scene;
}

bool breaks(const Scene& scene) {
  const double time = 1.2 / scene.projectiles[0].speed + 0.01;
  World world(scene);
  while (world.frame().time < time && world.frame().crack_events.empty()) world.step();
  return !world.frame().crack_events.empty();
}

/// The lowest speed that breaks the plate, to 2 % [m/s].
double threshold_speed(double young_modulus, double time_step) {
  double holds = 2, breaking = 200;
  while (breaking > 1.02 * holds) {
    const double middle = std::sqrt(holds * breaking);
    (breaks(struck_plate(young_modulus, time_step, middle)) ? breaking : holds) = middle;
  }
  return breaking;
}

TEST(ImpactThreshold, WhetherAPlateBreaksDoesNotDependOnTheTimeStep) {
  for (double young_modulus : {15e9, 70e9}) {
    std::vector<double> thresholds;
    for (double time_step : {1.0 / 60, 1.0 / 120, 1.0 / 480})
      thresholds.push_back(threshold_speed(young_modulus, time_step));
    const double mean = std::accumulate(thresholds.begin(), thresholds.end(), 0.0) / 3;
    EXPECT_GT(mean, 4);
    EXPECT_LT(mean, 100);
    for (double threshold : thresholds) EXPECT_NEAR(threshold, mean, 0.1 * mean) << young_modulus;
  }
}

TEST(ImpactThreshold, AStifferPlateBreaksAtALowerSpeed) {
  EXPECT_LT(threshold_speed(70e9, 1.0 / 120), threshold_speed(15e9, 1.0 / 120));
}

/// Half a period of ball and beam lasts 4.5 ms, less than a step. By energy the beam breaks from 0.96 m/s on, from 1.15
/// m/s on if the ball's impact on the mass of the beam is plastic.
TEST(ImpactThreshold, ABeamOnBearingsBreaksAlikeInStepsLongerThanItBends) {
  for (const double time_step : {1.0 / 60, 1.0 / 120, 1.0 / 250}) {
    EXPECT_FALSE(breaks(struck_beam(time_step, 1.0))) << time_step;
    EXPECT_TRUE(breaks(struck_beam(time_step, 1.35))) << time_step;
  }
  EXPECT_TRUE(breaks(struck_beam(1.0 / 30, 1.5)));
}

}  // namespace
}  // namespace griffith
