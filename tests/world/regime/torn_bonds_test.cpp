// What bonds cannot hold flies apart when microsteps end, whatever the time step and the budget.

#include <gtest/gtest.h>

#include <algorithm>

#include "sim/world/energy/energy_account.h"
#include "sim/world/world.h"

namespace griffith {
namespace {

/// A disc of concrete in free flight that spins at 1.5 times its bursting speed.
Scene bursting_disc(double element, double time_step, double budget) {
  Scene scene;
  scene.gravity.setZero();
  scene.ground.reset();
  scene.simulation.time_step = time_step;
  scene.simulation.step_budget = budget;
  BodyDescription& disc = scene.bodies.emplace_back();
  disc.shape = DiscShape{0.5, 0.05, Vec2(element, 0.05)};
  disc.material = *find_material_preset("concrete");
  disc.angular_velocity = Vec3(0, 0, 167.7);
  return scene;
}

void expect_flies_apart(const Frame& frame, const Totals& before) {
  double largest = 0;
  for (const BodyView& piece : frame.bodies) largest = std::max(largest, piece.mass);
  EXPECT_GT(frame.bodies.size(), 40);
  EXPECT_LT(largest, 0.1 * before.mass);
  EXPECT_GT(frame.totals.kinetic_energy, 0.99 * before.kinetic_energy);
  EXPECT_NEAR(frame.totals.angular_momentum.norm() / before.angular_momentum.norm(), 1, 3e-3);
}

class TornBonds : public ::testing::TestWithParam<double> {};

TEST_P(TornBonds, ADiscBurstsAlike) {
  World world(bursting_disc(0.1, GetParam(), 10));
  const Totals before = world.frame().totals;
  while (world.frame().time < 0.999 / 60) world.step();
  const Frame frame = world.frame();
  expect_flies_apart(frame, before);
  EXPECT_GT(frame.bodies.size(), 55);
  EXPECT_LT(frame.bodies.size(), 125);
  EXPECT_NEAR(frame.energy.fracture / frame.energy.fracture_energy, 1, 0.1);
  EXPECT_LT(std::abs(frame.energy.unaccounted()), 1e-5 * before.kinetic_energy);
}

INSTANTIATE_TEST_SUITE_P(TimeSteps, TornBonds, ::testing::Values(1.0 / 60, 1.0 / 240, 1.0 / 1000));

TEST(TornBondsBeyondTheCeiling, ADiscFliesApart) {
  World world(bursting_disc(0.07, 1.0 / 240, 0.5));
  const Totals before = world.frame().totals;
  int unfinished = 0;
  for (int step = 0; step < 2; ++step) {
    world.step();
    unfinished += world.frame().report.unfinished_explicit;
  }
  EXPECT_GT(unfinished, 0);
  expect_flies_apart(world.frame(), before);
}

}  // namespace
}  // namespace griffith
