#include <gtest/gtest.h>

#include <cmath>

#include "sim/world/world.h"
#include "tests/world/scenes.h"

namespace griffith {
namespace {

using testing::brick;
using testing::struck_block;

/// A beam along x, held at its left end, soft enough to be seen sagging.
Scene beam() {
  Scene scene;
  scene.ground.reset();
  BodyDescription body;
  body.shape = BoxShape{Vec3(4, 1, 1), Vec3::Constant(0.5), BoxPattern::five_tet};
  body.material = brick(1);
  body.material.young_modulus = 1e8;
  body.supports = {{.region = HalfSpaceRegion{Vec3(-2, 0, 0), -Vec3::UnitX()}}};
  scene.bodies = {body};
  scene.simulation.relative_residual = 1e-8;
  scene.simulation.fracture = false;
  return scene;
}

double tip_deflection(const World& world) {
  const Frame frame = world.frame();
  double sum = 0;
  int count = 0;
  for (std::size_t i = 0; i < frame.positions.size(); ++i)
    if (frame.rest_positions[i].x() > 1.99) {
      sum += frame.positions[i].y() - frame.rest_positions[i].y();
      ++count;
    }
  return sum / count;
}

Vec3 total_reaction(const World& world) {
  Vec3 sum = Vec3::Zero();
  for (const Vec3& reaction : world.frame().reactions) sum += reaction;
  return sum;
}

double static_deflection() {
  Scene scene = beam();
  scene.analysis = Analysis::equilibrium;
  World world(scene);
  world.step();
  EXPECT_LT(world.frame().report.max_relative_residual, 1e-8);
  EXPECT_EQ(world.frame().report.unconverged_solves, 0);
  return tip_deflection(world);
}

TEST(StaticAnalysis, ReactionsCarryTheWeight) {
  Scene scene = beam();
  scene.analysis = Analysis::equilibrium;
  World world(scene);
  world.step();
  const Vec3 weight = world.frame().totals.mass * scene.gravity;
  EXPECT_LT((total_reaction(world) + weight).norm(), 1e-7 * weight.norm());
  EXPECT_LT(tip_deflection(world), -1e-3);
}

TEST(StaticAnalysis, ADampedDynamicRunEndsThere) {
  Scene scene = beam();
  scene.simulation.static_start = false;
  scene.bodies[0].material.mass_damping = 20;
  World world(scene);
  for (int i = 0; i < 600; ++i) world.step();
  EXPECT_NEAR(tip_deflection(world), static_deflection(), 1e-5 * std::abs(static_deflection()));
}

TEST(StaticStart, ASupportedBodyDoesNotRing) {
  World world(beam());
  const double start = tip_deflection(world);
  EXPECT_NEAR(start, static_deflection(), 1e-8);
  for (int i = 0; i < 120; ++i) {
    world.step();
    ASSERT_NEAR(tip_deflection(world), start, 1e-6 * std::abs(start)) << "step " << i;
  }
  const Vec3 weight = world.frame().totals.mass * Vec3(0, -9.81, 0);
  EXPECT_LT((total_reaction(world) + weight).norm(), 1e-3 * weight.norm());
}

TEST(StaticStart, WithoutItSuddenGravityDoublesTheDeflection) {
  Scene scene = beam();
  scene.simulation.static_start = false;
  scene.simulation.time_step = 1e-3;
  scene.bodies[0].material.stiffness_damping = 0;
  World world(scene);
  double deepest = 0;
  for (int i = 0; i < 400; ++i) {
    world.step();
    deepest = std::min(deepest, tip_deflection(world));
  }
  EXPECT_NEAR(deepest / static_deflection(), 2, 0.1);
}

TEST(ExplicitIntegration, AgreesWithTheImplicitOneAtSmallSteps) {
  Scene scene = beam();
  scene.simulation.static_start = false;
  scene.simulation.time_step = 2e-4;
  Scene other = scene;
  other.simulation.integrator = Integrator::symplectic_euler;
  World implicit(scene), symplectic(other);
  for (int i = 0; i < 300; ++i) {
    implicit.step();
    symplectic.step();
  }
  EXPECT_LT(tip_deflection(implicit), -1e-3);
  EXPECT_NEAR(tip_deflection(symplectic), tip_deflection(implicit), 0.03 * std::abs(tip_deflection(implicit)));
}

TEST(ExplicitIntegration, TakesTheSubstepsThatStabilityAsksFor) {
  Scene scene = beam();
  scene.simulation.integrator = Integrator::symplectic_euler;
  World soft(scene);
  scene.bodies[0].material.young_modulus *= 100;
  World stiff(scene);
  soft.step();
  stiff.step();
  EXPECT_GT(soft.frame().report.substeps, 1);
  EXPECT_NEAR(stiff.frame().report.substeps / static_cast<double>(soft.frame().report.substeps), 10, 2.5);
  for (int i = 0; i < 60; ++i) soft.step();
  EXPECT_LT(std::abs(tip_deflection(soft)), 0.1) << "stable";
}

TEST(ExplicitIntegration, KeepsMomentumThroughAnImpactThatBreaksABlock) {
  Scene scene = struck_block(brick(0.1));
  scene.simulation.integrator = Integrator::symplectic_euler;
  World world(scene);
  world.step();
  const Vec3 before = world.frame().totals.momentum;
  for (int step = 0; step < 20; ++step) world.step();
  EXPECT_LT((world.frame().totals.momentum - before).norm(), 1e-6 * before.norm());
  EXPECT_GT(world.frame().crack_events.size(), 0u);
}

TEST(DuctileMaterial, KeepsItsBendWhereABrittleOneBreaks) {
  Scene scene = beam();
  scene.simulation.fracture = true;
  Material& material = scene.bodies[0].material;
  material.tensile_strength = 1e9;
  material.yield_strength = 5e4;
  material.mass_damping = 5;
  World ductile(scene);
  material.yield_strength.reset();
  World elastic(scene);
  for (int i = 0; i < 200; ++i) {
    ductile.step();
    elastic.step();
  }
  EXPECT_LT(tip_deflection(ductile), 1.2 * tip_deflection(elastic)) << "it has crept further down";
  EXPECT_EQ(ductile.frame().report.non_finite_values, 0);
}

}  // namespace
}  // namespace griffith
