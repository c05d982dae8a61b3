#include "sim/fracture/softened_impact.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>

#include "sim/parallel.h"
#include "sim/world/world.h"

namespace griffith {
namespace {

/// Weightless space with one body of boxes.
Scene body_of(const Vec3& size, double element_size) {
  Scene scene;
  scene.gravity.setZero();
  scene.ground.reset();
  BodyDescription body;
  body.shape = BoxShape{size, Vec3::Constant(element_size), BoxPattern::five_tet};
  body.material.tensile_strength = 1e6;
  scene.bodies = {body};
  return scene;
}

/// A bar that lands with its whole end on ground without friction.
Scene landing_bar(double length, double speed) {
  Scene scene = body_of(Vec3(0.2, length, 0.2), 0.1);
  scene.ground = Ground{0, 0, 0};
  scene.bodies[0].material.friction = 0;
  scene.bodies[0].material.poisson_ratio = 0.3;
  scene.bodies[0].position = Vec3(0, length / 2 + 0.05, 0);
  scene.bodies[0].velocity = Vec3(0, -speed, 0);
  return scene;
}

/// A body that a sphere strikes off its middle.
Scene struck(const Vec3& size, double element_size, double mass, double speed) {
  Scene scene = body_of(size, element_size);
  ProjectileBurst shot;
  shot.position = Vec3(0.02, 0.01, 0.5);
  shot.speed = speed;
  shot.mass = mass;
  shot.radius = 0.05;
  scene.projectiles = {shot};
  return scene;
}

bool breaks(Scene scene, double time_step, int substeps) {
  scene.simulation.time_step = time_step;
  scene.simulation.impact_substeps = substeps;
  const double speed = scene.projectiles.empty() ? scene.bodies[0].velocity.norm() : scene.projectiles[0].speed;
  World world(scene);
  const double time = 0.6 / speed + 0.02;
  while (world.frame().time < time && world.frame().crack_events.empty()) world.step();
  return !world.frame().crack_events.empty();
}

/// The lowest speed that breaks the body, to 2 % [m/s].
double breaking_speed(const std::function<Scene(double)>& scene_at, double time_step, int substeps) {
  double holds = 0.05, breaking = 500;
  while (breaking > 1.02 * holds) {
    const double middle = std::sqrt(holds * breaking);
    (breaks(scene_at(middle), time_step, substeps) ? breaking : holds) = middle;
  }
  return breaking;
}

// Read without softening, one substep breaks these bodies at 10 to 50 times the speed.
TEST(SoftenedImpact, OneLongSubstepBreaksABarAtTheSpeedAtWhichManyDo) {
  const std::vector<std::function<Scene(double)>> scenes = {
      [](double speed) { return landing_bar(1, speed); },
      [](double speed) { return landing_bar(2, speed); },
      [](double speed) { return struck(Vec3(1, 0.1, 0.1), 0.1, 0.1, speed); },
  };
  for (std::size_t i = 0; i < scenes.size(); ++i) {
    const double resolved = breaking_speed(scenes[i], 1.0 / 2000, 256);
    EXPECT_NEAR(breaking_speed(scenes[i], 1.0 / 120, 1), resolved, 0.2 * resolved) << "scene " << i;
  }
}

// The factor knows the body's length alone, not how the blow spreads.
TEST(SoftenedImpact, WhateverTheBudgetThreeDimensionalBodiesBreakWithinAFactorOfThree) {
  const std::vector<std::function<Scene(double)>> scenes = {
      [](double speed) { return struck(Vec3(1, 0.1, 0.1), 0.1, 1, speed); },
      [](double speed) { return struck(Vec3(0.8, 0.8, 0.1), 0.1, 2, speed); },
      [](double speed) { return struck(Vec3(0.6, 0.6, 0.6), 0.15, 20, speed); },
  };
  for (std::size_t i = 0; i < scenes.size(); ++i) {
    const double resolved = breaking_speed(scenes[i], 1.0 / 2000, 256);
    for (int substeps : {1, 3, 8}) {
      const double ratio = breaking_speed(scenes[i], 1.0 / 120, substeps) / resolved;
      EXPECT_GT(ratio, 1.0 / 3) << "scene " << i << ", substeps " << substeps;
      EXPECT_LT(ratio, 3) << "scene " << i << ", substeps " << substeps;
    }
  }
}

/// A hanging bar, drawn to just below its strength, that a sphere touches.
Scene loaded_bar(double mass) {
  Scene scene = struck(Vec3(1, 0.1, 0.1), 0.1, mass, 2);
  BodyDescription& bar = scene.bodies[0];
  bar.material.poisson_ratio = 0;
  bar.supports = {{HalfSpaceRegion{Vec3(-0.5, 0, 0), -Vec3::UnitX()}}};
  Load pull;
  pull.region = HalfSpaceRegion{Vec3(0.5, 0, 0), Vec3::UnitX()};
  pull.kind = LoadKind::traction;
  pull.traction = Vec3(0.97 * bar.material.tensile_strength, 0, 0);
  bar.loads = {pull};
  scene.simulation.impact_substeps = 1;
  return scene;
}

/// The lowest factor of the first body in some steps.
double least_factor(World& world, int steps) {
  double least = 1;
  for (int i = 0; i < steps; ++i) {
    world.step();
    for (const BodyView& body : world.frame().bodies)
      if (body.softened) least = std::min(least, body.softened->factor);
  }
  return least;
}

TEST(SoftenedImpact, WhatStrainedABodyBeforeIsHeldAgainstItsFullStrength) {
  World touched(loaded_bar(1e-6));
  EXPECT_LT(least_factor(touched, 40), 0.1) << "the touch was an impact";
  EXPECT_TRUE(touched.frame().crack_events.empty());
  World hit(loaded_bar(1));
  least_factor(hit, 40);
  EXPECT_FALSE(hit.frame().crack_events.empty()) << "and a blow does break it";
}

TEST(SoftenedImpact, NothingIsSoftenedWhereTheBudgetSuffices) {
  Scene scene = struck(Vec3(1, 0.1, 0.1), 0.1, 1, 20);
  scene.simulation.impact_substeps = 256;
  scene.bodies[0].material.tensile_strength *= 100;  // cracks would take their share of the budget
  World resolved(scene);
  EXPECT_EQ(least_factor(resolved, 20), 1);
  EXPECT_GT(resolved.frame().report.peak_margin, 0);
}

TEST(SoftenedImpact, TheEffectiveMaterialKeepsTheBreakingSpeed) {
  const Scene scene = [] {
    Scene made = struck(Vec3(1, 0.1, 0.1), 0.1, 1, 2);
    made.simulation.impact_substeps = 1;
    return made;
  }();
  const Material& material = scene.bodies[0].material;
  World world(scene);
  std::optional<SoftenedImpact> impact;
  for (int i = 0; i < 200 && !impact; ++i) {
    world.step();
    impact = world.frame().bodies[0].softened;
  }
  ASSERT_TRUE(impact);
  const double speed = material.tensile_strength / std::sqrt(material.young_modulus * material.density);
  const double effective = impact->tensile_strength / std::sqrt(impact->young_modulus * material.density);
  EXPECT_NEAR(effective, speed, 1e-9 * speed);
  EXPECT_EQ(impact->tets, 50);
  EXPECT_EQ(reason(*impact).find("50 tetrahedra leave 1 substep of"), 0u) << reason(*impact);
}

// Measured on waves in bars: the stress of an impact that implicit Euler shows, against c·dt/L.
TEST(SoftenedImpact, TheFactorIsTheShareOfTheStressThatALongSubstepShows) {
  for (const auto& [courant, share] : {std::pair(0.25, 1.0), {1.0, 0.75}, {2.0, 0.46}, {4.0, 0.24}})
    EXPECT_NEAR(softening_factor(1, 1, courant, 0), share, 0.05) << courant;
  EXPECT_EQ(softening_factor(3000, 2, 1e-4, 1e-4), 1);
  EXPECT_EQ(softening_factor(3000, 2, 1e-5, 1e-4), 1);
}

TEST(SoftenedImpact, TheSameBitsForAnyNumberOfThreads) {
  const auto hash = [](int threads) {
    const ThreadLimit limit(threads);
    Scene scene = struck(Vec3(2, 2, 0.2), 0.1, 5, 30);
    scene.simulation.impact_substeps = 1;
    World world(scene);
    EXPECT_LT(least_factor(world, 6), 1);
    EXPECT_FALSE(world.frame().crack_events.empty());
    return world.state_hash();
  };
  const std::uint64_t one = hash(1);
  EXPECT_EQ(hash(2), one);
  EXPECT_EQ(hash(4), one);
}

}  // namespace
}  // namespace griffith
