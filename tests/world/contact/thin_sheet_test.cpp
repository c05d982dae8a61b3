#include <gtest/gtest.h>

#include <cmath>

#include "sim/world/world.h"

namespace griffith {
namespace {

/// A sheet of glass, much thinner than its elements are long, lies on four legs; a brick falls on it.
Scene glass_table() {
  Scene scene;
  scene.simulation.time_step = 1.0 / 120;
  const auto add = [&](const Vec3& size, const Vec3& element_size, const Vec3& position, const char* material) {
    BodyDescription body;
    body.name = "body " + std::to_string(scene.bodies.size());
    body.shape = BoxShape{size, element_size, BoxPattern::five_tet};
    body.position = position;
    body.material = *find_material_preset(material);
    scene.bodies.push_back(body);
  };
  add(Vec3(0.8, 0.008, 0.8), Vec3(0.08, 0.008, 0.08), Vec3(0, 0.604, 0), "soda_lime_glass");
  for (const double x : {-0.35, 0.35})
    for (const double z : {-0.35, 0.35}) add(Vec3(0.1, 0.6, 0.1), Vec3(0.1, 0.15, 0.1), Vec3(x, 0.3, z), "concrete");
  add(Vec3(0.21, 0.065, 0.1), Vec3(0.07, 0.065, 0.05), Vec3(0.05, 0.9, 0), "brick");
  scene.bodies.back().rotation_degrees = Vec3(0, 0, 30);
  scene.bodies.back().velocity = Vec3(0, -5.8, 0);
  return scene;
}

TEST(ThinSheet, IsNotPushedFromItsFarSide) {
  for (const double budget : {10.0, 2000.0}) {
    Scene scene = glass_table();
    scene.simulation.step_budget = budget;
    World world(scene);
    for (int i = 0; i < 30; ++i) {
      world.step();
      const EnergyAccount& energy = world.frame().energy;
      ASSERT_LT(std::abs(energy.unaccounted()), 0.01 * energy.turned_over()) << "step " << i << ", budget " << budget;
      ASSERT_LE(energy.stored(), 1.01 * energy.put_in()) << "step " << i << ", budget " << budget;
    }
    EXPECT_GT(world.frame().fragments, 0) << "the brick broke";
  }
}

}  // namespace
}  // namespace griffith
