#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "sim/core/error.h"
#include "sim/world/setup/build_world.h"
#include "sim/world/state/world_state.h"
#include "sim/world/step.h"
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
  for (std::size_t i = 0; i < frame.nodes.positions.size(); ++i)
    if (frame.nodes.rest_positions[i].x() > 1.99) {
      sum += frame.nodes.positions[i].y() - frame.nodes.rest_positions[i].y();
      ++count;
    }
  return sum / count;
}

Vec3 total_reaction(const World& world) {
  Vec3 sum = Vec3::Zero();
  for (const Vec3& reaction : world.frame().nodes.reactions) sum += reaction;
  return sum;
}

double static_deflection() {
  Scene scene = beam();
  scene.analysis = Analysis::static_;
  World world(scene);
  world.step();
  EXPECT_LT(world.frame().report.max_relative_residual, 1e-8);
  EXPECT_EQ(world.frame().report.unconverged_solves, 0);
  return tip_deflection(world);
}

TEST(StaticAnalysis, ReactionsCarryTheWeight) {
  Scene scene = beam();
  scene.analysis = Analysis::static_;
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

/// A pressure turns and grows with the face that it acts on; balance is that with the faces as they are in the end.
TEST(StaticAnalysis, AnEquilibriumThatStaysIsNotFoundAgain) {
  Scene scene = beam();
  scene.analysis = Analysis::static_;
  Load pull;
  pull.kind = LoadKind::traction;
  pull.region = HalfSpaceRegion{Vec3(2, 0, 0), Vec3::UnitX()};
  pull.traction = Vec3(1e4, 0, 0);
  pull.start = 3.5 * scene.simulation.time_step;
  scene.bodies[0].loads = {pull};
  World world(scene);
  std::vector<std::uint64_t> hashes;
  std::vector<int> iterations;
  for (int i = 0; i < 6; ++i) {
    world.step();
    hashes.push_back(world.state_hash());
    iterations.push_back(world.frame().report.solver_iterations);
    EXPECT_GT(world.frame().report.peak_utilization, 0) << i;
  }
  EXPECT_GT(iterations[0], 0);
  EXPECT_EQ(iterations[1] + iterations[2], 0);
  EXPECT_EQ(hashes[2], hashes[0]);
  EXPECT_GT(iterations[3], 0) << "the load has set in";
  EXPECT_NE(hashes[3], hashes[2]);
  EXPECT_EQ(iterations[4], 0);
  Material softer = scene.bodies[0].material;
  softer.young_modulus /= 2;
  world.set_material(0, softer);
  world.step();
  EXPECT_GT(world.frame().report.solver_iterations, 0) << "the material has changed";
}

TEST(StaticAnalysis, APressureIsInBalanceInItsFirstStep) {
  Scene scene = beam();
  scene.analysis = Analysis::static_;
  Load pressure;
  pressure.kind = LoadKind::pressure;
  pressure.region = HalfSpaceRegion{Vec3(0, 0.5, 0), Vec3::UnitY()};
  pressure.pressure = 1e5;
  scene.bodies[0].loads = {pressure};
  World world(scene);
  world.step();
  const double first = tip_deflection(world);
  EXPECT_LT(first, -0.2) << "far enough for the faces to turn";
  EXPECT_EQ(world.frame().report.unconverged_solves, 0);
  const Vec3 weight = world.frame().totals.mass * scene.gravity;
  Vec3 load = Vec3::Zero();
  for (const Vec3& force : world.frame().nodes.load_forces) load += force;
  EXPECT_LT((total_reaction(world) + weight + load).norm(), 1e-8 * load.norm());
  for (int step = 0; step < 5; ++step) world.step();
  EXPECT_NEAR(tip_deflection(world), first, 1e-8 * std::abs(first));
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
  other.simulation.integrator = Integrator::explicit_;
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
  scene.simulation.integrator = Integrator::explicit_;
  scene.bodies[0].elements = ElementOrder::linear;
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

/// A soft deformable body takes one, and the report says so.
TEST(ExplicitIntegration, CountsASingleSubstepAsOne) {
  Scene scene = beam();
  scene.simulation.integrator = Integrator::explicit_;
  scene.simulation.time_step = 1e-5;
  scene.bodies[0].material.young_modulus = 1e6;
  World world(scene);
  world.step();
  EXPECT_EQ(world.frame().report.substeps, 1);
}

/// Damping this strong needs 10⁸ substeps: more than an int's worth of them must neither wrap round nor be made.
TEST(ExplicitIntegration, RefusesMoreSubstepsThanItMakes) {
  Scene scene = beam();
  scene.simulation.integrator = Integrator::explicit_;
  scene.simulation.time_step = 0.1;
  scene.bodies[0].material.young_modulus = 2e11;
  Material damped = scene.bodies[0].material;
  damped.stiffness_damping = 1000;
  World world(scene);
  EXPECT_THROW(world.set_material(0, damped), InputError);
  EXPECT_EQ(world.frame().materials[0], scene.bodies[0].material) << "it goes on with what it had";
  scene.bodies[0].material = damped;
  try {
    World refused(scene);
    FAIL();
  } catch (const InputError& error) {
    EXPECT_EQ(error.where(), "#/bodies/0/material");
    EXPECT_NE(error.problem().find("substeps a step"), std::string::npos) << error.what();
  }
}

/// Slivers that cracks or cuts leave can ask for any number of them.
TEST(ExplicitIntegration, FreezesABodyThatComesToNeedMoreSubstepsThanItMakes) {
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  for (const double frequency : {1e12, kInfinity})
    for (const bool supported : {true, false}) {
      Scene scene = beam();
      scene.simulation.integrator = Integrator::explicit_;
      scene.bodies.resize(2, scene.bodies[0]);
      scene.bodies[1].position.z() = 5;
      scene.bodies[1].velocity.x() = 3;
      if (!supported) scene.bodies[1].supports.clear();
      WorldState world = build_world(scene);
      world.bodies[1].highest_frequency = frequency;
      advance(world);
      EXPECT_EQ(world.report.non_finite_values, 1);
      EXPECT_LT(world.report.substeps, 100);
      EXPECT_TRUE(world.bodies[1].rigid);
      EXPECT_FALSE(world.bodies[0].rigid);
      EXPECT_NEAR(world.bodies[1].motion.velocity.x(), supported ? 0 : 3, 1e-9);
      advance(world);
      EXPECT_EQ(world.report.non_finite_values, 0) << "once and for all";
    }
}

/// Pieces and cut elements are stiffer for their mass than what they were part of.
TEST(ExplicitIntegration, StaysStableWhileAStepCutsElements) {
  Scene scene = struck_block(brick(0.1));
  scene.simulation.integrator = Integrator::explicit_;
  scene.simulation.time_step = 1.5e-4;
  scene.projectiles.clear();
  scene.bodies[0].remeshing = true;
  scene.bodies[0].angular_velocity = Vec3(1, 2, 60);  // more than it bears
  World world(scene);
  scene.simulation.fracture = false;
  World whole(scene);
  const double energy = world.frame().totals.kinetic_energy;
  whole.step();
  world.step();
  const Frame frame = world.frame();
  EXPECT_GT(frame.elements.tets.size(), whole.frame().elements.tets.size());
  EXPECT_GT(frame.report.substeps, whole.frame().report.substeps);
  EXPECT_EQ(frame.report.non_finite_values, 0);
  EXPECT_LT(frame.totals.kinetic_energy + frame.totals.elastic_energy, 1.1 * energy);
}

TEST(ExplicitIntegration, KeepsMomentumThroughAnImpactThatBreaksABlock) {
  Scene scene = struck_block(brick(0.1));
  scene.simulation.integrator = Integrator::explicit_;
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
