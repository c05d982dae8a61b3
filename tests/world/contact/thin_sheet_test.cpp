#include <gtest/gtest.h>

#include <cmath>

#include "tests/world/contact/contact_scenes.h"

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

constexpr double kSheetThickness = 2e-3;

/// A cube of steel falls by half a meter on a sheet of wood that lies on the ground and weighs a 350th of it.
Scene struck_sheet(double tilt, double time_step) {
  Scene scene;
  scene.simulation.time_step = time_step;
  const Material wood = testing::unbreakable(testing::preset("wood_along_grain"));
  const Material steel = testing::unbreakable(testing::preset("mild_steel"));
  const double height = 0.05 + kSheetThickness + 0.5 + (tilt > 0 ? 0.02 : 0);
  scene.bodies = {testing::box("sheet", Vec3(0.15, kSheetThickness, 0.15), Vec3(0, kSheetThickness / 2, 0), wood,
                               Vec3(0.05, kSheetThickness, 0.05)),
                  testing::box("cube", Vec3::Constant(0.1), Vec3(0, height, 0), steel, Vec3::Constant(0.05))};
  scene.bodies[1].rotation_degrees = Vec3(0.4 * tilt, 0, tilt);
  return scene;
}

// A gap that closes from rest, a corner that meets the sheet above the ground: it was pressed 1.4 mm, or flung 6 mm,
// into the ground.
TEST(ThinSheet, LiesBetweenTheGroundAndWhatFallsOnIt) {
  for (const double tilt : {0.0, 15.0})
    for (const double rate : {30.0, 60.0, 250.0}) {
      World world(struck_sheet(tilt, 1 / rate));
      double deepest = 0;
      while (world.frame().time < 1.5) {
        world.step();
        deepest = std::max(deepest, testing::depth_below(world.frame()));
      }
      EXPECT_LT(deepest, 0.05 * kSheetThickness) << "tilt " << tilt << ", 1/" << rate;
    }
}

// Within a step a block comes down from 5 mm, at rest, on a sheet that lies still.
TEST(ThinSheet, CarriesWhatFallsFromRestWithinAStep) {
  for (const double rate : {30.0, 60.0, 250.0}) {
    Scene scene = struck_sheet(0, 1 / rate);
    scene.bodies[1].position.y() -= 0.495;
    World world(scene);
    testing::run_to_rest(world, 2);
    EXPECT_NEAR(world.frame().bodies[1].center_of_mass.y(), 0.05 + kSheetThickness, 0.03 * kSheetThickness)
        << "1/" << rate;
  }
}

}  // namespace
}  // namespace griffith
