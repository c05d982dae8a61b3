// A bar in tension by a slow ramp: it cracks when the stress reaches the strength, at every time step.

#include <gtest/gtest.h>

#include "sim/world/world.h"

namespace griffith {
namespace {

constexpr double kRamp = 0.4;       // [s]
constexpr double kStrengths = 1.7;  // traction at its end

Scene pulled_bar(double time_step, ElementOrder elements) {
  Scene scene;
  scene.gravity.setZero();
  scene.ground.reset();
  scene.simulation.time_step = time_step;
  BodyDescription& bar = scene.bodies.emplace_back();
  bar.shape = BoxShape{Vec3(1, 0.2, 0.2), Vec3(0.1, 0.1, 0.1), BoxPattern::five_tet};
  bar.elements = elements;
  bar.material = *find_material_preset("concrete");
  for (const double side : {-1.0, 1.0}) {
    Load& pull = bar.loads.emplace_back();
    pull.kind = LoadKind::traction;
    pull.region = HalfSpaceRegion{Vec3(side / 2, 0, 0), Vec3(side, 0, 0)};
    pull.traction = Vec3(side * kStrengths * bar.material.tensile_strength, 0, 0);
    pull.ramp = kRamp;
  }
  return scene;
}

/// Returns the time of the first crack [s].
double crack_onset(const Scene& scene) {
  World world(scene);
  while (world.frame().crack_events.empty() && world.frame().time < kRamp) world.step();
  return world.frame().crack_events.empty() ? 2 * kRamp : world.frame().crack_events.front().time;
}

TEST(CrackOnset, IsWhereStressReachesStrengthAtEveryTimeStep) {
  for (const ElementOrder elements : {ElementOrder::linear, ElementOrder::quadratic})
    for (const double rate : {10, 30, 60, 250, 1000})
      EXPECT_NEAR(crack_onset(pulled_bar(1 / rate, elements)), kRamp / kStrengths, 0.02 * kRamp / kStrengths)
          << "at " << rate << " steps a second";
}

}  // namespace
}  // namespace griffith
