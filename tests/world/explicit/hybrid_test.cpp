// Impacts with the hybrid integrator: waves by microsteps.

#include <gtest/gtest.h>

#include "sim/core/parallel.h"
#include "sim/scene/scene_reader.h"
#include "sim/world/world.h"
#include "tests/world/fracture/crack_area.h"
#include "tests/world/scenes.h"

namespace griffith {
namespace {

/// A free plate of concrete of 1 m in weightless space that a ball of 5 kg strikes.
Scene struck_plate(double speed, double time_step, int shot_number = 0) {
  Scene scene;
  scene.gravity.setZero();
  scene.ground.reset();
  scene.simulation.integrator = Integrator::hybrid;
  scene.simulation.time_step = time_step;
  BodyDescription plate;
  plate.shape = BoxShape{Vec3(1, 1, 0.1), Vec3(0.125, 0.125, 0.05), BoxPattern::five_tet};
  plate.material = *find_material_preset("concrete");
  scene.bodies = {plate};
  ProjectileBurst shot;
  shot.position = Vec3(0.03 + 0.01 * shot_number, 0.05 - 0.015 * shot_number, 0.16);
  shot.speed = speed;
  shot.mass = 5;
  shot.radius = 0.08;
  scene.projectiles = {shot};
  return scene;
}

struct Damage {
  double pieces = 0;
  double area = 0;  ///< area of cracks [m²]
  std::uint64_t hash = 0;
};

Damage damage_of(const Scene& scene, double duration) {
  World world(scene);
  for (double time = 0; time < duration; time += scene.simulation.time_step) world.step();
  return {static_cast<double>(world.frame().bodies.size()), testing::crack_area(world.frame()), world.state_hash()};
}

/// The mean of some shots near one another: a single one scatters.
Damage mean_damage(double speed, double time_step) {
  constexpr int kShots = 4;
  Damage mean;
  for (int shot = 0; shot < kShots; ++shot) {
    const Damage damage = damage_of(struck_plate(speed, time_step, shot), 1.0 / 30);
    mean.pieces += damage.pieces / kShots;
    mean.area += damage.area / kShots;
  }
  return mean;
}

TEST(Hybrid, WhatBreaksDependsOnTheSpeedAndNotOnTheTimeStep) {
  Damage slower;
  for (const double speed : {11.0, 40.0}) {
    const Damage fine = mean_damage(speed, 1e-3);
    EXPECT_GT(fine.pieces, 5);
    EXPECT_GT(fine.pieces, 2 * slower.pieces);
    EXPECT_GT(fine.area, 1.5 * slower.area);
    for (const double time_step : {1.0 / 30, 1.0 / 60}) {
      const Damage coarse = mean_damage(speed, time_step);
      EXPECT_NEAR(coarse.pieces, fine.pieces, 0.3 * fine.pieces) << speed << " m/s, " << time_step << " s";
      EXPECT_NEAR(coarse.area, fine.area, 0.2 * fine.area) << speed << " m/s, " << time_step << " s";
    }
    slower = fine;
  }
}

/// Overload of a node lasts, and a crack takes its time, however many steps that is: a wave crosses an element of this
/// plate in 50 µs.
TEST(Hybrid, StepsShorterThanTheTransitOfAnElementBreakAsMuch) {
  constexpr int kShots = 6;
  const auto mean_damage_in = [](double time_step) {
    Damage mean;
    for (int shot = 0; shot < kShots; ++shot) {
      Scene scene = struck_plate(25, time_step, shot);
      scene.bodies[0].shape = BoxShape{Vec3(1, 1, 0.1), Vec3(0.2, 0.2, 0.1), BoxPattern::five_tet};
      const Damage damage = damage_of(scene, 1.0 / 30);
      mean.pieces += damage.pieces / kShots;
      mean.area += damage.area / kShots;
    }
    return mean;
  };
  const Damage usual = mean_damage_in(1.0 / 120);
  EXPECT_GT(usual.pieces, 10);
  for (const double time_step : {1.0 / 30, 1.0 / 1000, 1.0 / 10000, 1.0 / 40000}) {
    const Damage damage = mean_damage_in(time_step);
    EXPECT_NEAR(damage.pieces, usual.pieces, 0.3 * usual.pieces) << time_step << " s";
    EXPECT_NEAR(damage.area, usual.area, 0.2 * usual.area) << time_step << " s";
  }
}

TEST(Hybrid, MomentumIsKeptAndEnergyNeverGrows) {
  World world(struck_plate(15, 1.0 / 60));
  const double momentum = 5 * 15;
  double energy = std::numeric_limits<double>::infinity();
  for (int i = 0; i < 20; ++i) {
    world.step();
    const Totals& totals = world.frame().totals;
    EXPECT_NEAR(totals.momentum.norm(), momentum, 1e-5 * momentum);
    EXPECT_LE(totals.kinetic_energy + totals.elastic_energy, energy * (1 + 1e-3));
    energy = totals.kinetic_energy + totals.elastic_energy;
  }
}

TEST(Hybrid, TheNumberOfThreadsChangesNoBit) {
  std::vector<std::uint64_t> hashes;
  for (const int threads : {1, 2, 4}) {
    const ThreadLimit limit(threads);
    hashes.push_back(damage_of(struck_plate(15, 1.0 / 60), 0.05).hash);
  }
  EXPECT_EQ(hashes[1], hashes[0]);
  EXPECT_EQ(hashes[2], hashes[0]);
}

/// A wall that tears off its foot where it is struck.
Scene struck_wall(Integrator integrator, int shot_number) {
  Scene scene;
  scene.simulation.integrator = integrator;
  BodyDescription wall;
  wall.shape = BoxShape{Vec3(2.5, 2, 0.25), Vec3(0.3125, 0.333, 0.25), BoxPattern::kuhn};
  wall.elements = ElementOrder::linear;
  wall.position = Vec3(0, 1, 0);
  wall.material = *find_material_preset("brick");
  wall.material.young_modulus = 1e9;
  wall.material.tensile_strength = wall.material.fracture_toughness = 250e3;
  wall.supports = {{HalfSpaceRegion{Vec3(0, -1, 0), -Vec3::UnitY()}}};
  scene.bodies = {wall};
  scene.projectiles = {{.position = Vec3(0.2 + 0.05 * shot_number, 1.2, -0.29),
                        .direction = Vec3::UnitZ(),
                        .speed = 15,
                        .mass = 60,
                        .radius = 0.15}};
  return scene;
}

/// Supports that tear set back no node that waits: a wall cracks as far as in explicit steps.
TEST(Hybrid, AWallThatTearsOffItsFootBreaksAsInExplicitSteps) {
  double hybrid = 0, explicitly = 0;
  for (int shot = 0; shot < 3; ++shot) {
    hybrid += damage_of(struck_wall(Integrator::hybrid, shot), 0.016).area;
    explicitly += damage_of(struck_wall(Integrator::explicit_, shot), 0.016).area;
  }
  EXPECT_GT(hybrid, 0.7 * explicitly);
  EXPECT_LT(hybrid, 1.3 * explicitly);
}

TEST(Hybrid, DebrisThatSpinsBesideTheGroundCutsNoStepToPieces) {
  World world(read_scene(std::string(GRIFFITH_SOURCE_DIR) + "/scenes/vase_shot.json"));
  for (int step = 0; step < 110; ++step) {
    world.step();
    EXPECT_LE(world.frame().report.substeps, 16) << step;
  }
  EXPECT_GT(world.frame().bodies.size(), 25u);
}

TEST(Hybrid, SlowImpactsAndRestNeedNoMicrosteps) {
  World slow(struck_plate(0.05, 1.0 / 60));
  for (int i = 0; i < 20; ++i) {
    slow.step();
    EXPECT_EQ(slow.frame().report.microsteps, 0);
  }
  Scene scene = testing::shot_wall(Vec3(3, 3, 1), 1, testing::brick(1));
  scene.projectiles.clear();
  scene.simulation.integrator = Integrator::hybrid;
  World standing(scene);
  for (int i = 0; i < 20; ++i) {
    standing.step();
    EXPECT_EQ(standing.frame().report.microsteps, 0);
  }
  EXPECT_EQ(standing.frame().bodies.size(), 1u);
}

TEST(Hybrid, AShotWallOnItsFootBreaksAndRests) {
  Scene scene = testing::shot_wall(Vec3(4, 4, 1), 1, testing::brick(0.02));
  scene.simulation.integrator = Integrator::hybrid;
  World world(scene);
  int microsteps = 0;
  for (int i = 0; i < 60; ++i) {
    world.step();
    microsteps += world.frame().report.microsteps;
    EXPECT_EQ(world.frame().report.non_finite_values, 0);
  }
  EXPECT_GT(microsteps, 0);
  EXPECT_GT(world.frame().crack_events.size(), 0u);
}

}  // namespace
}  // namespace griffith
