// The energy account of bodies that are struck: scaled ones, with moving supports, and until they turn rigid again.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>

#include "sim/scene/scene_reader.h"
#include "sim/world/world.h"
#include "tests/world/measures.h"

namespace griffith {
namespace {

/// A bar in weightless space, held at one end, near the other end of which a sphere strikes it.
Scene struck_bar() {
  Scene scene;
  scene.gravity.setZero();
  scene.ground.reset();
  scene.simulation.fracture = false;
  scene.simulation.step_budget = 1e5;
  BodyDescription bar;
  bar.shape = BoxShape{Vec3(1, 0.1, 0.1), Vec3::Constant(0.1), BoxPattern::five_tet};
  bar.elements = ElementOrder::linear;  // quadratic ones are not scaled
  bar.material.tensile_strength = 1e6;  // so that the impact counts as potentially harmful
  bar.supports = {{HalfSpaceRegion{Vec3(-0.5, 0, 0), -Vec3::UnitX()}}};
  ProjectileBurst shot;
  shot.position = Vec3(0.42, 0.01, 0.2);
  shot.speed = 2;
  shot.mass = 1;
  shot.radius = 0.05;
  scene.bodies = {bar};
  scene.projectiles = {shot};
  return scene;
}

TEST(EnergyAccount, ScaledBodiesTakeAsMuchLessFromTheirLoadsAsTheyAreScaled) {
  Scene scene = struck_bar();
  scene.simulation.step_budget = 0.1;
  scene.bodies[0].loads = {{.region = HalfSpaceRegion{Vec3(0.5, 0, 0), Vec3::UnitX()},
                            .kind = LoadKind::traction,
                            .traction = Vec3(5e6, 0, -2e5)}};
  World world(scene);
  double compared = 0;
  std::optional<double> factor;
  EnergyAccount last;  // of a step that was scaled to its end, if the next one is scaled, too
  for (int i = 0; i < 20; ++i) {
    world.step();
    const Frame frame = world.frame();
    ASSERT_LT(testing::fraction_unaccounted(frame.energy), 1e-3) << "step " << i;
    const std::optional<ScaledImpact>& scaled = frame.bodies[0].scaled;
    if (scaled && factor) {
      EXPECT_NEAR(last.scaling, (1 - *factor) * last.loads, 1e-5 * std::abs(last.loads)) << "step " << i - 1;
      compared += std::abs(last.loads);
    }
    factor = scaled ? std::optional(scaled->factor) : std::nullopt;
    last = frame.energy_of_step;
  }
  EXPECT_GT(compared, 0.1 * world.frame().energy.turned_over());
  EXPECT_FALSE(factor) << "and explicit dynamics has ended";
}

TEST(EnergyAccount, AScaledBodyClosesUnderItsWeight) {
  Scene scene = struck_bar();
  scene.simulation.step_budget = 0.1;
  scene.gravity = Vec3(0, 0, -300);
  scene.projectiles[0].position.z() = 0.12;
  scene.projectiles[0].speed = 10;
  scene.projectiles[0].mass = 0.1;
  World world(scene);
  double maximum = 0;
  for (int i = 0; i < 40; ++i) {
    world.step();
    ASSERT_LT(testing::fraction_unaccounted(world.frame().energy), 1e-3) << "step " << i;
    maximum = std::max(maximum, std::abs(world.frame().energy.scaling));
  }
  EXPECT_GT(maximum, 0.1 * world.frame().energy.turned_over());
  EXPECT_FALSE(world.frame().bodies[0].scaled) << "explicit dynamics has ended";
}

TEST(EnergyAccount, MovingSupportsWorkInMicrosteps) {
  Scene scene = struck_bar();
  scene.bodies[0].supports[0].kind = SupportKind::prescribed;
  scene.bodies[0].supports[0].velocity = scene.bodies[0].velocity = Vec3(0, 0, 1);
  scene.simulation.static_start = false;
  scene.simulation.relative_residual = 1e-10;  // what a solve leaves over works, too
  World world(scene);
  double work = 0;
  for (int i = 0; i < 20; ++i) {
    world.step();
    const Frame frame = world.frame();
    ASSERT_LT(testing::fraction_unaccounted(frame.energy), 1e-3) << "step " << i;
    if (frame.report.microsteps > 0) work += std::abs(frame.energy_of_step.supports);
  }
  EXPECT_GT(work, 0.05 * world.frame().energy.turned_over());
}

/// A free plate that two spheres strike one after the other, too weakly to break it.
TEST(EnergyAccount, WhatVibratesInAPieceIsLostWhenItTurnsRigid) {
  Scene scene = struck_bar();
  scene.bodies[0].shape = BoxShape{Vec3(1, 1, 0.05), Vec3(0.1, 0.1, 0.05), BoxPattern::five_tet};
  scene.bodies[0].supports.clear();
  scene.bodies[0].material.tensile_strength = 4e6;
  scene.projectiles[0].position = Vec3(0.02, 0.01, 0.2);
  scene.projectiles[0].speed = 1;
  scene.projectiles[0].mass = 0.5;
  scene.projectiles.push_back(scene.projectiles[0]);
  scene.projectiles[1].position = Vec3(0.3, -0.2, 0.2);
  scene.projectiles[1].start = 0.3;
  World world(scene);
  int struck = 0;
  double lost = 0;
  for (int i = 0; i < 70; ++i) {
    const bool was_rigid = world.frame().bodies[0].rigid;
    world.step();
    const Frame frame = world.frame();
    ASSERT_LT(testing::fraction_unaccounted(frame.energy), 2e-4) << "step " << i;
    struck += was_rigid && frame.report.microsteps > 0;
    lost = std::max(lost, frame.energy_of_step.regime_change);
  }
  EXPECT_GT(struck, 0) << "and woken";
  EXPECT_GT(lost, 0.01 * world.frame().energy.turned_over());
}

/// A vase with flat quadratic tets, which cracks leave alone with a node: its microsteps become shorter.
TEST(EnergyAccount, OfAVaseWhoseMicrostepsBecomeShorterCloses) {
  Scene scene = read_scene(std::string(GRIFFITH_SOURCE_DIR) + "/scenes/vase_shot.json");
  scene.simulation.step_budget = 1000;
  World world(scene);
  for (int i = 0; i < 3; ++i) world.step();
  EXPECT_GT(world.frame().report.cracks, 50);
  EXPECT_LT(testing::fraction_unaccounted(world.frame().energy), 2e-4);
}

}  // namespace
}  // namespace griffith
