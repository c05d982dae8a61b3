// The energy account: each entry by its own law, and all of them together.

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "sim/core/parallel.h"
#include "sim/world/world.h"
#include "tests/world/fracture/crack_area.h"
#include "tests/world/measures.h"
#include "tests/world/scenes.h"

namespace griffith {
namespace {

/// A block of soft rubber without friction or damping that comes to the ground at 2 m/s.
Scene bouncing_block(Integrator integrator) {
  Scene scene;
  scene.simulation.integrator = integrator;
  scene.simulation.fracture = false;
  scene.simulation.time_step = 1e-3;
  scene.ground->friction = 0;
  BodyDescription block;
  block.shape = BoxShape{Vec3(0.5, 0.5, 0.5), Vec3::Constant(0.125), BoxPattern::five_tet};
  block.position = Vec3(0, 0.26, 0);
  block.velocity = Vec3(0, -2, 0);
  block.material.young_modulus = 1e7;
  block.material.density = 1000;
  block.material.tensile_strength = 1e3;  // so that the impact counts as potentially harmful
  block.material.friction = 0;
  block.material.stiffness_damping = 0;
  scene.bodies = {block};
  return scene;
}

TEST(EnergyAccount, AFrictionlessBounceClosesThroughoutInMicrosteps) {
  World world(bouncing_block(Integrator::hybrid));
  int microsteps = 0;
  for (int i = 0; i < 40; ++i) {
    world.step();
    const Frame frame = world.frame();
    ASSERT_NEAR(frame.energy.unaccounted(), 0, 1e-4 * frame.energy.start) << "step " << i;
    ASSERT_LE(frame.energy.stored(), 1.001 * frame.energy.put_in()) << "step " << i;
    microsteps += frame.report.microsteps;
  }
  const EnergyAccount energy = world.frame().energy;
  EXPECT_GT(microsteps, 0);
  EXPECT_NEAR(energy.start, 0.5 * 125 * 2 * 2, 1e-6);
  EXPECT_EQ(energy.material_damping, 0);
  EXPECT_GT(energy.microstep_damping, 0);
}

/// A box that slides over the ground, made to stop within the run.
TEST(EnergyAccount, ASlidingBlockLosesMuMgdToFriction) {
  Scene scene;
  scene.simulation.time_step = 1e-3;
  const double friction = 0.3, mass = 8, speed = 2;
  scene.ground->friction = friction;
  ProjectileBurst box;
  box.shape = BoxProjectile{Vec3(0.4, 0.1, 0.4)};
  box.position = Vec3(0, 0.05, 0);
  box.direction = Vec3::UnitX();
  box.speed = speed;
  box.mass = mass;
  box.friction = friction;
  scene.projectiles = {box};
  World world(scene);
  for (int i = 0; i < 500; ++i) world.step();
  const Frame frame = world.frame();
  const double way = frame.projectiles[0].position.x(), work = friction * mass * scene.gravity.norm() * way;
  EXPECT_GT(way, 0.5);
  EXPECT_NEAR(frame.energy.contacts, work, 0.01 * work);
  EXPECT_NEAR(frame.energy.projectiles, 0.5 * mass * speed * speed, 1e-9);
  EXPECT_LT(testing::fraction_unaccounted(frame.energy), 1e-3);
}

/// A bar of mild steel without inertia to speak of, drawn to five times its yield strain.
TEST(EnergyAccount, APlasticBarTakesItsYieldStressTimesItsFlow) {
  Scene scene;
  scene.gravity.setZero();
  scene.ground.reset();
  scene.simulation.fracture = false;
  scene.simulation.time_step = 1e-3;
  BodyDescription bar;
  const double length = 1, area = 0.01, young_modulus = 2e9, yield = 2e7, rate = 0.5;
  bar.shape = BoxShape{Vec3(length, 0.1, 0.1), Vec3::Constant(0.1), BoxPattern::five_tet};
  bar.material.young_modulus = young_modulus;
  bar.material.poisson_ratio = 0.3;
  bar.material.density = 1000;
  bar.material.yield_strength = yield;
  bar.material.mass_damping = 20;
  Support left{.region = HalfSpaceRegion{Vec3(-length / 2, 0, 0), -Vec3::UnitX()},
               .kind = SupportKind::sliding,
               .normal = Vec3::UnitX()};
  Support right{.region = HalfSpaceRegion{Vec3(length / 2, 0, 0), Vec3::UnitX()},
                .kind = SupportKind::prescribed,
                .velocity = rate * Vec3::UnitX()};
  bar.supports = {left, right};
  scene.bodies = {bar};
  World world(scene);
  const int steps = 100;
  for (int i = 0; i < steps; ++i) world.step();
  const EnergyAccount energy = world.frame().energy;
  const double drawn = rate * steps * scene.simulation.time_step, flow = drawn - length * yield / young_modulus;
  EXPECT_NEAR(energy.plastic, yield * area * flow, 0.1 * energy.plastic);
  EXPECT_GT(energy.supports, energy.plastic);
  EXPECT_LT(testing::fraction_unaccounted(energy), 0.01);
}

/// A shot at a wall on the ground that goes to pieces.
Scene shot_at_wall(Integrator integrator) {
  const double strength = integrator == Integrator::hybrid ? 0.5 : 0.02;  // long steps average an impact away
  Scene scene = testing::shot_wall(Vec3(2, 2, 0.25), 0.25, testing::brick(strength));
  scene.simulation.integrator = integrator;
  scene.projectiles[0].start = 0;
  return scene;
}

TEST(EnergyAccount, AnImpactWithCracksClosesAndNothingIsGained) {
  for (const Integrator integrator : {Integrator::implicit, Integrator::hybrid}) {
    World world(shot_at_wall(integrator));
    EnergyAccount sum = world.frame().energy;
    for (int i = 0; i < 20; ++i) {
      world.step();
      const Frame frame = world.frame();
      sum += frame.energy_of_step;
      ASSERT_LT(testing::fraction_unaccounted(frame.energy), 2e-3) << "step " << i;
      const double rounding = 1e-3 * frame.energy.turned_over();
      for (double EnergyAccount::*loss : {&EnergyAccount::contacts, &EnergyAccount::material_damping,
                                          &EnergyAccount::microstep_damping, &EnergyAccount::plastic})
        ASSERT_GE(frame.energy.*loss, -rounding) << "step " << i;
    }
    const EnergyAccount energy = world.frame().energy;
    EXPECT_FALSE(world.frame().crack_events.empty());
    EXPECT_GT(energy.fracture_energy, 0);
    for (const EnergyEntry& entry : energy_entries())
      EXPECT_NEAR(sum.*entry.value, energy.*entry.value, 1e-9 * energy.turned_over()) << entry.key;
  }
}

TEST(EnergyAccount, CountsOneSideOfEachCrackAtItsToughness) {
  Scene scene = shot_at_wall(Integrator::implicit);
  Material& force = scene.bodies[0].material;  // its cracks have no bonds
  force.criterion = FractureCriterion::separation_force;
  force.separation_toughness = force.tensile_strength * 0.25 * 0.25;
  World world(scene);
  for (int i = 0; i < 20; ++i) world.step();
  const Frame frame = world.frame();
  const double area = testing::crack_area(frame);
  const Material& material = scene.bodies[0].material;
  const double per_area =
      std::pow(material.fracture_toughness, 2) * (1 - std::pow(material.poisson_ratio, 2)) / material.young_modulus;
  EXPECT_GT(area, 0);
  EXPECT_NEAR(frame.energy.crack_area, area, 1e-9 * area);
  EXPECT_NEAR(frame.energy.fracture_energy, per_area * area, 1e-9 * per_area * area);
}

/// Bonds take the fracture energy. Where they still hold, cracks count by what these have taken.
TEST(EnergyAccount, CracksTakeTheEnergyOfTheirArea) {
  for (const Integrator integrator : {Integrator::hybrid, Integrator::implicit}) {
    World world(shot_at_wall(integrator));
    for (int i = 0; i < 20; ++i) world.step();
    const Frame frame = world.frame();
    EXPECT_GT(frame.energy.crack_area, 0);
    EXPECT_LT(frame.energy.crack_area, testing::crack_area(frame));
    if (integrator == Integrator::hybrid) {
      EXPECT_NEAR(frame.energy.fracture, frame.energy.fracture_energy, 0.1 * frame.energy.fracture_energy);
    } else {  // a single crack in a zigzag of faces, which tilt by acos(1/√3) at most from its plane, that of the bonds
      EXPECT_LE(frame.energy.fracture, frame.energy.fracture_energy);
      EXPECT_GT(frame.energy.fracture, frame.energy.fracture_energy / std::sqrt(3.0));
    }
  }
}

TEST(EnergyAccount, TheNumberOfThreadsChangesNoBit) {
  for (const Integrator integrator : {Integrator::implicit, Integrator::hybrid}) {
    std::vector<EnergyAccount> accounts;
    for (const int threads : {1, 2, 4}) {
      const ThreadLimit limit(threads);
      World world(shot_at_wall(integrator));
      for (int i = 0; i < 12; ++i) world.step();
      accounts.push_back(world.frame().energy);
    }
    for (const EnergyEntry& entry : energy_entries()) {
      EXPECT_EQ(accounts[1].*entry.value, accounts[0].*entry.value) << entry.key;
      EXPECT_EQ(accounts[2].*entry.value, accounts[0].*entry.value) << entry.key;
    }
  }
}

TEST(EnergyAccount, AnEditedMaterialIsAccountedFor) {
  Scene scene = shot_at_wall(Integrator::implicit);
  World world(scene);
  for (int i = 0; i < 12; ++i) world.step();
  Material heavy = scene.bodies[0].material;
  heavy.density *= 2;
  heavy.young_modulus /= 2;
  world.set_material(0, heavy);
  for (int i = 0; i < 8; ++i) world.step();
  EXPECT_NE(world.frame().energy.edits, 0);
  EXPECT_LT(testing::fraction_unaccounted(world.frame().energy), 0.01);
}

}  // namespace
}  // namespace griffith
