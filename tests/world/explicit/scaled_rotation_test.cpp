// Rotation of bodies that are scaled by dynamic similarity.

#include <gtest/gtest.h>

#include <limits>

#include "sim/world/explicit/explicit_regime.h"
#include "sim/world/explicit/similarity.h"
#include "sim/world/motion/elastic_phase.h"
#include "sim/world/motion/motion_phase.h"
#include "sim/world/setup/build_world.h"
#include "sim/world/state/world_state.h"
#include "tests/world/contact/contact_scenes.h"

namespace griffith {
namespace {

/// A bar of 1 m in weightless space that does not break.
Scene bar_of(double element_size) {
  Scene scene;
  scene.gravity.setZero();
  scene.ground.reset();
  scene.simulation.time_step = 1.0 / 60;
  Material strong;
  strong.tensile_strength = 1e9;
  scene.bodies = {testing::box("bar", Vec3(1, 0.1, 0.1), Vec3::Zero(), strong, Vec3::Constant(element_size))};
  scene.bodies[0].elements = ElementOrder::linear;  // quadratic ones are not scaled
  return scene;
}

double largest_stress(const WorldState& world) {
  double largest = 0;
  for (const TetId tet : IdRange<TetId>(0, world.mesh->tet_count()))
    largest = std::max(largest, world.elements.states[tet].stress.full().norm());
  return largest;
}

/// A bar that has been in microsteps for a sixtieth of a second, scaled by f.
struct ScaledBar {
  WorldState world;

  ScaledBar(const Scene& scene, const Vec3& spin, double factor) : world(build_world(scene)) {
    for (const NodeId node : world.bodies[0].nodes)
      world.nodes.velocities[node] = spin.cross(world.nodes.positions[node] - pivot());
    update_motion(world, world.bodies[0]);
    begin_explicit(world, world.bodies[0], 1);
    set_similarity(world, world.bodies[0], factor);
    EXPECT_TRUE(run_explicit(world, {}, 1.0 / 60, std::numeric_limits<double>::infinity()));
  }
  Vec3 pivot() const { return world.bodies[0].supported() ? Vec3(-0.5, 0, 0) : Vec3(Vec3::Zero()); }
  double spin() const { return motion_of(world, world.bodies[0]).angular_velocity.z(); }
};

/// The stress that a rotation causes is that of the real body: scaled, it would be 1/f times as large beside strength.
TEST(Similarity, ASpinningBarIsStressedByItsSpin) {
  const Scene scene = bar_of(0.1);
  constexpr double kSpin = 10;  // [1/s]
  const double stress = 0.5 * scene.bodies[0].material.density * kSpin * kSpin * 0.25;
  for (const double factor : {1.0, 0.3, 0.1}) {
    const ScaledBar bar(scene, kSpin * Vec3::UnitZ(), factor);
    EXPECT_NEAR(bar.spin(), kSpin, 1e-3 * kSpin) << factor;
    EXPECT_GT(largest_stress(bar.world), 0.2 * stress) << factor;
    EXPECT_LT(largest_stress(bar.world), 2.5 * stress) << factor << ", it rings";
  }
}

TEST(Similarity, AHingedBarFallsAsItWouldUnscaled) {
  Scene scene = bar_of(0.05);
  scene.gravity = Vec3(0, -9.81, 0);
  scene.simulation.static_start = false;
  scene.bodies[0].supports = {{BoxRegion{Vec3(-0.501, -0.001, -1), Vec3(-0.499, 0.001, 1)}}};
  for (const double spin : {0.0, -3.0}) {
    const double unscaled = ScaledBar(scene, spin * Vec3::UnitZ(), 1).spin();
    EXPECT_NEAR(unscaled - spin, -1.5 * 9.81 / 60, 0.02);
    for (const double factor : {0.3, 0.1})
      EXPECT_NEAR(ScaledBar(scene, spin * Vec3::UnitZ(), factor).spin(), unscaled, 0.01) << factor << ", it rings";
  }
}

}  // namespace
}  // namespace griffith
