// Coulomb's law of what slides, whatever the mesh, the step and the size.

#include <gtest/gtest.h>

#include "tests/world/contact/contact_case.h"
#include "tests/world/contact/contact_scenes.h"

namespace griffith {
namespace {

using testing::box;
using testing::ContactCase;
using testing::kEarthGravity;
using testing::preset;

class SlidingLaw : public testing::ContactLaw<ContactCase> {};

/// A granite block on a slope of `degrees`, friction 0.6: gravity leans instead of the ground.
Scene block_on_slope(const ContactCase& at, double degrees, double element) {
  Scene scene = testing::empty_scene(at);
  const double slope = degrees * M_PI / 180;
  scene.gravity = kEarthGravity * Vec3(std::sin(slope), -std::cos(slope), 0);
  scene.ground->friction = 0.6;
  scene.bodies = {
      box("block", at.size * Vec3(1, 1.0 / 3, 1), Vec3(0, at.size / 6, 0), preset("granite"), Vec3::Constant(element))};
  scene.bodies[0].material.friction = 0.6;
  return scene;
}

// Newton and Coulomb: m dv/dt = m g sin a − µ m g cos a.
void check_speed_on_slope(const ContactCase& at, double degrees, double element) {
  constexpr double kDuration = 0.5;
  World world(block_on_slope(at, degrees, element));
  testing::run_to(world, kDuration);
  const double slope = degrees * M_PI / 180;
  const BodyView& block = world.frame().bodies[0];
  testing::check_near("speed after .5 s at " + testing::short_text(degrees) + " degrees [m/s]", block.velocity.x(),
                      kEarthGravity * (std::sin(slope) - 0.6 * std::cos(slope)) * kDuration);
  testing::check_at_most("speed across at " + testing::short_text(degrees) + " degrees [m/s]",
                         std::hypot(block.velocity.y(), block.velocity.z()), 0.01);
  EXPECT_TRUE(world.frame().crack_events.empty());
}

TEST_P(SlidingLaw, ABlockGainsItsSpeedOnASteepSlope) {
  for (const double degrees : {33.0, 45.0})
    check_speed_on_slope(GetParam(), degrees, GetParam().size / 3 / GetParam().refinement);
}

TEST_P(SlidingLaw, ABlockOfOneCellGainsItsSpeedOnASteepSlope) { check_speed_on_slope(GetParam(), 33, GetParam().size); }

// The work of friction µ m g d is ½ m v². A step that ends with its own speed goes half a step less far, as in free
// fall (x = x₀ + v₀t − ½gt(t+h)).
TEST_P(SlidingLaw, ALaunchedPlateStopsWhereItsFrictionSaysAndStaysWhole) {
  const ContactCase& at = GetParam();
  Scene scene = testing::empty_scene(at);
  const double friction = 0.5, speed = 2 * std::sqrt(at.size), cell = at.size / 4 / at.refinement;
  const double thickness = at.size / 20;
  scene.ground->friction = friction;
  scene.bodies = {box("plate", Vec3(at.size, thickness, at.size), Vec3(0, thickness / 2, 0), preset("concrete"),
                      Vec3(cell, thickness, cell))};
  scene.bodies[0].material.friction = friction;
  scene.bodies[0].velocity = Vec3(speed, 0, 0);
  World world(scene);
  const double distance = speed * speed / (2 * friction * kEarthGravity), stop = speed / (friction * kEarthGravity);
  testing::run_to(world, stop + 1);
  const double half_step = speed * at.time_step / 2;
  const double got = world.frame().bodies[0].center_of_mass.x();
  testing::record("stops after [m]", got,
                  testing::short_text(distance - half_step) + ".." + testing::short_text(distance));
  EXPECT_LE(got, 1.02 * distance) << "stops after [m]";
  EXPECT_GE(got, 0.98 * distance - half_step) << "stops after [m]";
  testing::check_at_most("speed at the end [m/s]", world.frame().bodies[0].velocity.norm(), 1e-5);
  testing::check_at_most("off its line [m]", std::abs(world.frame().bodies[0].center_of_mass.z()), 0.01 * distance);
  testing::check_equal("cracks", static_cast<int>(world.frame().crack_events.size()), 0);
}

INSTANTIATE_TEST_SUITE_P(Grid, SlidingLaw, ::testing::ValuesIn(testing::contact_cases({0.01, 0.3, 1, 10})),
                         testing::contact_case_name);

}  // namespace
}  // namespace griffith
