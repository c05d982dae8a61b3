// Planks that bend under what lies on them, and planks across one another, rest at any time step.

#include <gtest/gtest.h>

#include <cmath>

#include "tests/world/contact/contact_scenes.h"

namespace griffith {
namespace {

using testing::box;
using testing::preset;

constexpr double kRates[] = {30, 60, 120, 250};  // steps a second

/// A plank of 2 m on two blocks with 1.6 m between them, and a cube of granite of 20 cm in its middle.
Scene shelf(const Material& material, double rate) {
  Scene scene;
  scene.simulation.time_step = 1 / rate;
  for (const double x : {-0.9, 0.9})
    scene.bodies.push_back(
        box(x < 0 ? "left" : "right", Vec3(0.2, 0.2, 0.4), Vec3(x, 0.1, 0), preset("granite"), Vec3::Constant(0.1)));
  scene.bodies.push_back(box("plank", Vec3(2, 0.05, 0.3), Vec3(0, 0.225, 0), material, Vec3(0.1, 0.05, 0.1)));
  scene.bodies.push_back(box("cube", Vec3::Constant(0.2), Vec3(0, 0.35, 0), preset("granite"), Vec3::Constant(0.1)));
  return scene;
}

/// Deflection of the plank under both edges of the cube and its own weight, that of its ends included [m].
double shelf_deflection(const Material& plank) {
  const double span = 1.6, end = 0.2, width = 0.3, height = 0.05, arm = (span - 0.2) / 2;
  const double stiffness = plank.young_modulus * width * std::pow(height, 3) / 12;
  const double weight = plank.density * width * height * testing::kEarthGravity,
               force = preset("granite").density * std::pow(0.2, 3) * testing::kEarthGravity / 2;
  return (force * arm * (3 * span * span - 4 * arm * arm) / 24 + 5 * weight * std::pow(span, 4) / 384 -
          weight * end * end / 2 * span * span / 8) /
         stiffness;
}

TEST(Planks, AShelfSagsAsBeamTheorySaysAndStaysOnItsSupports) {
  const Material abs = preset("abs");
  for (const double rate : kRates) {
    World world(shelf(abs, rate));
    testing::run_to(world, 3);
    const Frame frame = world.frame();
    EXPECT_TRUE(testing::all_asleep(frame)) << rate;
    EXPECT_FALSE(testing::has_crack(frame)) << rate;
    EXPECT_NEAR(0.35 - frame.bodies[3].center_of_mass.y(), shelf_deflection(abs), 0.08 * shelf_deflection(abs)) << rate;
    EXPECT_LT(std::abs(frame.energy.limited), 1e-3) << rate;
  }
}

/// A plank of 2 m on a narrow block, with a cube at each end.
Scene seesaw(double rate) {
  Scene scene;
  scene.simulation.time_step = 1 / rate;
  scene.bodies = {
      box("block", Vec3(0.1, 0.2, 0.4), Vec3(0, 0.1, 0), preset("granite"), Vec3::Constant(0.1)),
      box("plank", Vec3(2, 0.05, 0.3), Vec3(0, 0.225, 0), preset("wood_along_grain"), Vec3(0.1, 0.05, 0.1))};
  for (const double x : {-0.8, 0.8})
    scene.bodies.push_back(
        box(x < 0 ? "left" : "right", Vec3::Constant(0.2), Vec3(x, 0.35, 0), preset("granite"), Vec3::Constant(0.1)));
  return scene;
}

TEST(Planks, ASeesawStaysLevel) {
  for (const double rate : kRates) {
    World world(seesaw(rate));
    testing::run_to(world, 4);
    const Frame frame = world.frame();
    EXPECT_TRUE(testing::all_asleep(frame)) << rate;
    const double left = frame.bodies[2].center_of_mass.y(), right = frame.bodies[3].center_of_mass.y();
    EXPECT_NEAR(left, right, 2e-4) << rate;
    EXPECT_NEAR(left, 0.3488, 2e-4) << rate;
  }
}

/// Three planks of 2 cm above one another, the upper two turned and one of them leaning, that fall by some centimeters.
Scene crossed_planks(const Material& material, double rate) {
  Scene scene;
  scene.simulation.time_step = 1 / rate;
  const Vec3 size(0.6, 0.02, 0.04), cell(0.1, 0.02, 0.1);
  scene.bodies = {box("low", size, Vec3(0, 0.01, 0), material, cell),
                  box("middle", size, Vec3(0, 0.08, 0), material, cell),
                  box("high", size, Vec3(0, 0.16, 0.02), material, cell)};
  scene.bodies[1].rotation_degrees = Vec3(0, 70, 0);
  scene.bodies[2].rotation_degrees = Vec3(0, 30, 3);
  return scene;
}

TEST(Planks, ThatCrossLieOnOneAnother) {
  for (const char* name : {"abs", "wood_along_grain", "mild_steel", "soda_lime_glass"})
    for (const double rate : kRates) {
      World world(crossed_planks(preset(name), rate));
      testing::run_to(world, 4);
      const Frame frame = world.frame();
      const auto at = ::testing::Message() << name << ", steps of 1/" << rate << " s";
      EXPECT_TRUE(testing::all_asleep(frame)) << at;
      if (frame.bodies.size() > 3) continue;  // it broke
      for (int plank = 0; plank < 3; ++plank)
        EXPECT_NEAR(frame.bodies[plank].center_of_mass.y(), 0.01 + 0.02 * plank, 4e-4) << at;
    }
}

}  // namespace
}  // namespace griffith
