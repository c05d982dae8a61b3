// A plate that falls on its corner: a sharp point far from its faces, at which an impact must be foreseen.

#include <gtest/gtest.h>

#include "sim/world/world.h"

namespace griffith {
namespace {

/// A plate of 1 m that has fallen 1.5 m, a little above the ground.
Scene falling_plate(double time_step) {
  Scene scene;
  scene.simulation.time_step = time_step;
  BodyDescription& plate = scene.bodies.emplace_back();
  plate.shape = BoxShape{Vec3(1, 1, 0.1), Vec3(0.1, 0.1, 0.1), BoxPattern::five_tet};
  plate.position = Vec3(0, 0.85, 0);
  plate.rotation_degrees = Vec3(15, 0, 35);
  plate.velocity = Vec3(0, -5.4, 0);
  plate.material = *find_material_preset("concrete");
  plate.material.fracture_toughness = 1.2e6;
  return scene;
}

double crack_area(double time_step) {
  World world(falling_plate(time_step));
  while (world.frame().time < 0.06) world.step();
  return world.frame().energy.crack_area;
}

TEST(CornerImpact, BreaksAlikeAtEveryTimeStep) {
  const double finest = crack_area(1.0 / 1000);
  EXPECT_GT(finest, 0.3);
  for (const double rate : {30, 60, 120, 250, 500})
    EXPECT_NEAR(crack_area(1 / rate), finest, 0.3 * finest) << "at " << rate << " steps a second";
}

}  // namespace
}  // namespace griffith
