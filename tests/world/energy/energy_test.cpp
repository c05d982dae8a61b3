#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "sim/world/world.h"
#include "tests/world/scenes.h"

namespace griffith {
namespace {

using testing::brick;
using testing::struck_block;

/// Kinetic, elastic and potential energy of all that moves [J].
double mechanical_energy(const Scene& scene, const Frame& frame) {
  double energy = frame.totals.kinetic_energy + frame.totals.elastic_energy;
  for (std::size_t i = 0; i < frame.nodes.positions.size(); ++i)
    energy -= frame.nodes.masses[i] * scene.gravity.dot(frame.nodes.positions[i]);
  for (const ProjectileView& projectile : frame.projectiles)
    energy -= projectile.mass * scene.gravity.dot(projectile.position);
  return energy;
}

struct Outcome {
  int bodies = 0;
  double lost = 0;  ///< share of the energy
};

/// Steps a scene without supports whose projectiles are launched in the first step: its energy must not grow.
Outcome expect_no_energy_created(const Scene& scene, int steps, const std::string& name) {
  World world(scene);
  world.step();
  const double first = mechanical_energy(scene, world.frame());
  double before = first;
  for (int step = 0; step < steps; ++step) {
    world.step();
    const double now = mechanical_energy(scene, world.frame());
    EXPECT_LE(now, before + 2e-2 * first) << name << " step " << step;
    EXPECT_LE(now, first * (1 + 2e-2)) << name << " step " << step;
    if (::testing::Test::HasFailure()) break;
    before = now;
  }
  return {static_cast<int>(world.frame().bodies.size()), 1 - before / first};
}

/// A pane tilted a little that falls on the ground.
Scene dropped_pane(const Material& material, double speed) {
  Scene scene;
  BodyDescription pane;
  pane.shape = BoxShape{Vec3(0.5, 0.5, 0.02), Vec3(0.1, 0.1, 0.02), BoxPattern::five_tet};
  pane.position = Vec3(0, 0.31, 0);
  pane.rotation_degrees = Vec3(10, 0, 25);
  pane.velocity = Vec3(0, -speed, 0);
  pane.material = material;
  scene.bodies = {pane};
  return scene;
}

TEST(Energy, APaneOfAnyMaterialThatHitsTheGroundGainsNone) {
  for (const MaterialPreset& preset : material_presets())
    expect_no_energy_created(dropped_pane(preset.material, 7), 40, std::string(preset.key));
}

TEST(Energy, AHardPaneThatShattersGainsNone) {
  Material glass = find_material_preset("soda_lime_glass").value();
  glass.tensile_strength *= 0.03;
  glass.fracture_toughness *= 0.03;
  const Outcome outcome = expect_no_energy_created(dropped_pane(glass, 7), 60, "glass");
  EXPECT_GT(outcome.bodies, 10);
  EXPECT_GT(outcome.lost, 0.1);
}

TEST(Energy, BlocksThatCollideGainNone) {
  std::mt19937 random(5);
  std::uniform_real_distribution<double> uniform(-1, 1);
  for (int trial = 0; trial < 6; ++trial) {
    Scene scene;
    scene.gravity.setZero();
    scene.ground.reset();
    for (double side : {-1.0, 1.0}) {
      BodyDescription block;
      block.name = side < 0 ? "left" : "right";
      block.shape = BoxShape{Vec3(1, 0.6 + 0.3 * uniform(random), 0.5), Vec3::Constant(0.3), BoxPattern::five_tet};
      block.position = Vec3(side, 0.3 * uniform(random), 0.2 * uniform(random));
      block.rotation_degrees = 40 * Vec3(uniform(random), uniform(random), uniform(random));
      block.velocity = Vec3(-side * 5, 0, 0);
      block.angular_velocity = 2 * Vec3(uniform(random), uniform(random), uniform(random));
      block.material = brick(trial % 2 ? 0.02 : 1);
      block.material.young_modulus *= trial % 3 == 0 ? 1e-2 : 1;
      scene.bodies.push_back(block);
    }
    expect_no_energy_created(scene, 60, "trial " + std::to_string(trial));
  }
}

/// Two blocks of random materials, soft and stiff, smooth and rough, that meet in weightless space. `size`: of the
/// blocks [m].
Scene meeting_blocks(int seed, double size) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> uniform(-1, 1);
  Scene scene;
  scene.gravity.setZero();
  scene.ground.reset();
  for (double side : {-1.0, 1.0}) {
    BodyDescription block;
    block.name = side < 0 ? "left" : "right";
    block.shape = BoxShape{size * Vec3(1, 0.6, 0.2), Vec3::Constant(0.3 * size), BoxPattern::five_tet};
    block.position = size * Vec3(0.7 * side, 0.2 * uniform(random), 0.1 * uniform(random));
    block.rotation_degrees = 90 * Vec3(uniform(random), uniform(random), uniform(random));
    block.velocity = Vec3(-side * 8, uniform(random), uniform(random));
    block.material = brick(std::pow(10, uniform(random)));
    block.material.young_modulus = std::pow(10, 8 + 3 * uniform(random));
    block.material.friction = 5 + 5 * uniform(random);
    block.material.element_model = seed % 3 ? ElementModel::green_strain : ElementModel::corotational;
    scene.bodies.push_back(block);
  }
  scene.simulation.time_step = size * (seed % 2 ? 0.03 : 0.005);
  return scene;
}

TEST(Energy, BlocksOfAnySizeThatMeetKeepTheirMomentumAndGainNone) {
  int seed = 0;
  for (double size : {1e-3, 1e-2, 0.1, 1.0, 10.0, 100.0, 1e3})
    for (int trial = 0; trial < 6; ++trial, ++seed) {
      World world(meeting_blocks(seed, size));
      const Totals before = world.frame().totals;
      const double scale = before.mass * 8;
      double maximum = before.kinetic_energy;
      for (int step = 0; step < 25; ++step) {
        world.step();
        const Totals now = world.frame().totals;
        const double energy = now.kinetic_energy + now.elastic_energy;
        ASSERT_LT((now.momentum - before.momentum).norm(), 1e-7 * scale) << "size " << size << ", seed " << seed;
        // Verlet's energy swings by ω² dt²/4 of what is in the highest frequencies, which is all in so few elements.
        ASSERT_LE(energy, maximum * (1 + 0.1)) << "size " << size << ", seed " << seed << ", step " << step;
        maximum = std::min(maximum, energy);
      }
    }
}

// A length scaled by s, with times scaled alike: speeds, stresses and what breaks are the same. Powers of two round
// alike.
TEST(Energy, ASceneScaledThroughoutBehavesAlike) {
  const auto outcome = [](int seed, double scale) {
    Scene scene = meeting_blocks(seed, scale);
    for (BodyDescription& body : scene.bodies) {
      body.material.fracture_toughness *= std::sqrt(scale);
      body.material.stiffness_damping *= scale;
    }
    World world(scene);
    for (int step = 0; step < 12; ++step) world.step();
    return std::pair(world.frame().totals.kinetic_energy / std::pow(scale, 3), world.frame().bodies.size());
  };
  for (const int seed : {2, 4, 8, 12, 13}) {
    const auto [energy, bodies] = outcome(seed, 1);
    for (const auto& [scale, tolerance] : {std::pair(1.0 / 1024, 1e-9), std::pair(1024.0, 1e-3)}) {
      const auto [scaled_energy, scaled_bodies] = outcome(seed, scale);
      EXPECT_NEAR(scaled_energy, energy, tolerance * energy) << "seed " << seed << ", scale " << scale;
      EXPECT_EQ(scaled_bodies, bodies) << "seed " << seed << ", scale " << scale;
    }
  }
}

/// Bar of brick, held by a line across its lower edge or by one corner.
Scene pendulum(double young_modulus, ElementOrder elements, bool by_corner) {
  Scene scene;
  scene.ground.reset();
  scene.simulation.static_start = false;
  BodyDescription& bar = scene.bodies.emplace_back();
  bar.shape = BoxShape{Vec3(1, 0.1, 0.1), Vec3(0.2, 0.1, 0.1), BoxPattern::five_tet};
  bar.elements = elements;
  bar.rotation_degrees = Vec3(0, 0, -30);
  bar.material = brick(1e3);
  bar.material.young_modulus = young_modulus;
  bar.material.stiffness_damping = 0;
  bar.supports = {{BoxRegion{Vec3(-0.501, -0.051, by_corner ? 0.049 : -1), Vec3(-0.499, -0.049, 1)}}};
  return scene;
}

/// Steps a pendulum on. Checks that its energy is never off by more than this share of the greatest kinetic energy.
/// Returns the energy unaccounted for over that.
double check_swing(const Scene& scene, int steps, double tolerance) {
  World world(scene);
  const double start = mechanical_energy(scene, world.frame());
  double most_kinetic = 0, farthest = 0;
  for (int step = 0; step < steps; ++step) {
    world.step();
    most_kinetic = std::max(most_kinetic, world.frame().totals.kinetic_energy);
    farthest = std::max(farthest, std::abs(mechanical_energy(scene, world.frame()) - start));
  }
  EXPECT_LT(farthest, tolerance * most_kinetic);
  return std::abs(world.frame().energy.unaccounted()) / most_kinetic;
}

TEST(Energy, APendulumSwingsOnWhateverItsStiffness) {
  for (const double young_modulus : {1e7, 7e10})
    for (const ElementOrder elements : {ElementOrder::linear, ElementOrder::quadratic})
      for (const bool by_corner : {false, true}) {
        SCOPED_TRACE(::testing::Message() << "E " << young_modulus << ", elements " << static_cast<int>(elements)
                                          << ", by a corner " << by_corner);
        // A ball joint turns about changing axes, which substeps follow less exactly.
        check_swing(pendulum(young_modulus, elements, by_corner), 1200, by_corner ? 0.045 : 0.015);
      }
}

// In a step it turns by up to 0.4 rad.
TEST(Energy, ASmallPendulumNeitherGainsNorLosesInLongSteps) {
  for (const bool by_corner : {false, true}) {
    SCOPED_TRACE(::testing::Message() << "by a corner " << by_corner);
    Scene scene = pendulum(7e10, ElementOrder::linear, by_corner);
    const double size = by_corner ? 0.5 : 0.05;  // a ball joint turns about changing axes, which is less exact
    auto& shape = std::get<BoxShape>(scene.bodies[0].shape);
    shape.size *= size, shape.element_size *= size;
    auto& region = std::get<BoxRegion>(scene.bodies[0].supports[0].region);
    region.minimum *= size, region.maximum *= size;
    scene.simulation.time_step = 1.0 / 60;
    EXPECT_LT(check_swing(scene, 600, 0.025), 1e-3) << "energy unaccounted for";
  }
}

// In a step it turns by radians, so that the linearized step would strain it.
TEST(Energy, AFastPieceOnAJointGainsNone) {
  for (const ElementOrder elements : {ElementOrder::linear, ElementOrder::quadratic})
    for (const double spin : {60.0, 400.0}) {
      Scene scene = pendulum(1e9, elements, true);
      scene.simulation.time_step = 1.0 / 60;
      scene.simulation.integrator = Integrator::implicit;
      scene.simulation.fracture = false;
      scene.bodies[0].shape = BoxShape{Vec3(0.1, 0.1, 0.1), Vec3::Constant(0.1), BoxPattern::five_tet};
      scene.bodies[0].supports = {{BoxRegion{Vec3(-0.051, -0.051, 0.049), Vec3(-0.049, -0.049, 1)}}};
      scene.bodies[0].angular_velocity = spin * Vec3(0.6, 0.5, 0.62);
      World world(scene);
      world.step();
      const Totals first = world.frame().totals;
      for (int step = 0; step < 120; ++step) {
        world.step();
        const Totals now = world.frame().totals;
        ASSERT_LT(now.kinetic_energy + now.elastic_energy, 1.1 * (first.kinetic_energy + first.elastic_energy) + 30)
            << spin << " rad/s, elements " << static_cast<int>(elements) << ", step " << step;
      }
      EXPECT_GT(first.kinetic_energy, 1) << "it does turn";
    }
}

TEST(Energy, AWallWhoseDebrisIsShotAgainGainsNone) {
  Scene scene = testing::shot_wall(Vec3(3, 3, 1), 1.5, brick(0.024));
  scene.projectiles[0].position = Vec3(0, 2, 6.5);
  World world(scene);
  std::size_t launched = 0;
  double before = 0;
  for (int step = 0; step < 120; ++step) {
    world.step();
    const Frame frame = world.frame();
    const double now = mechanical_energy(scene, frame);
    if (frame.projectiles.size() == launched && launched > 0) {
      EXPECT_LE(now, before + 2) << "step " << step;
    }
    launched = frame.projectiles.size();
    before = now;
  }
  EXPECT_GT(world.frame().bodies.size(), 5u);
}

TEST(Energy, MomentumAndEnergyStandThroughAThousandStepsWithAnImpactThatBreaks) {
  const Scene scene = struck_block(brick(0.1));
  World world(scene);
  world.step();
  const Totals before = world.frame().totals;
  for (int step = 0; step < 1000; ++step) {
    world.step();
    const Totals now = world.frame().totals;
    ASSERT_LT((now.momentum - before.momentum).norm(), 1e-6 * before.momentum.norm()) << "step " << step;
    ASSERT_LT((now.angular_momentum - before.angular_momentum).norm(), 1e-2 * before.angular_momentum.norm())
        << "step " << step;
    ASSERT_LE(now.kinetic_energy + now.elastic_energy, before.kinetic_energy * (1 + 1e-6)) << "step " << step;
  }
  EXPECT_GT(world.frame().bodies.size(), 1u) << "it did break";
}

}  // namespace
}  // namespace griffith
