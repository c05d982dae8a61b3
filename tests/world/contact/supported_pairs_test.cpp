// Two bodies that both have supports touch each other, against closed forms.

#include <gtest/gtest.h>

#include <cmath>

#include "tests/world/contact/contact_scenes.h"
#include "tests/world/measures.h"
#include "tests/world/scenes.h"

namespace griffith {
namespace {

using testing::box;
using testing::preset;
using testing::weightless_scene;

Support held(const Region& region) { return {.region = region}; }

Support on_rail(const Region& region, const Vec3& normal) {
  return {.region = region, .kind = SupportKind::sliding, .normal = normal, .can_tear = false};
}

Region everywhere() { return BoxRegion{Vec3::Constant(-9), Vec3::Constant(9)}; }

/// A strip of glass, 0.8 m between two lines on which it lies, and a steel punch that comes down on its middle by
/// `depth` [m] and stops.
Scene punched_strip(double rate, double depth) {
  constexpr double kSpeed = 0.02;  // [m/s]
  Scene scene = weightless_scene(rate);
  Material glass = preset("soda_lime_glass"), steel = preset("mild_steel");
  glass.friction = steel.friction = 0;
  glass.poisson_ratio = 0;
  scene.bodies = {box("strip", Vec3(0.9, 0.2, 0.01), Vec3::Zero(), glass, Vec3(0.05, 0.05, 0.01)),
                  box("punch", Vec3(0.02, 0.22, 0.06), Vec3(0, 0, 0.0352), steel, Vec3(0.02, 0.055, 0.03))};
  for (const double x : {-0.4, 0.4})
    scene.bodies[0].supports.push_back(
        on_rail(BoxRegion{Vec3(x - 1e-3, -0.1, -0.005), Vec3(x + 1e-3, 0.1, -0.005)}, Vec3::UnitZ()));
  scene.bodies[0].supports.push_back(held(BoxRegion{Vec3(-0.401, -0.1, -0.005), Vec3(-0.399, -0.1, -0.005)}));
  scene.bodies[0].supports.push_back(
      on_rail(BoxRegion{Vec3(0.399, -0.1, -0.005), Vec3(0.401, -0.1, -0.005)}, Vec3::UnitY()));
  scene.bodies[1].supports = {{.region = HalfSpaceRegion{Vec3(0, 0, 0.03), Vec3::UnitZ()},
                               .kind = SupportKind::prescribed,
                               .velocity = -kSpeed * Vec3::UnitZ(),
                               .stop = (depth + 2e-4) / kSpeed}};
  return scene;
}

// A beam on two supports, loaded in its middle: F = 48 E I w / L³ (Timoshenko 1940).
TEST(SupportedPairs, APunchBendsAStripByTheForceOfABeam) {
  constexpr double kDepth = 2e-3;
  const double inertia = 0.2 * std::pow(0.01, 3) / 12;
  for (const double rate : {30.0, 60.0, 250.0}) {
    World world(punched_strip(rate, kDepth));
    testing::run_to(world, 0.6);
    double force = 0;
    for (int step = 0; step < 10; ++step) {
      world.step();
      for (std::size_t node = 0; node < world.frame().nodes.reactions.size(); ++node)
        force += std::abs(world.frame().nodes.reactions[node].z()) / 20;
    }
    const double expected = 48 * preset("soda_lime_glass").young_modulus * inertia * kDepth / std::pow(0.8, 3);
    EXPECT_NEAR(force, expected, 0.03 * expected) << "1/" << rate << " s";
    EXPECT_LT(testing::fraction_unaccounted(world.frame().energy), 1e-3) << "1/" << rate << " s";
  }
}

// The tip of a loaded cantilever comes down on another one: w = (q b L⁴/8 - R L³/3)/EI above, R L³/3EI below.
TEST(SupportedPairs, ACantileverRestsOnAnother) {
  constexpr double kGap = 0.005, kLength = 0.6, kTraction = 60;
  for (const double rate : {30.0, 60.0, 250.0}) {
    Scene scene = weightless_scene(rate);
    Material acrylic = preset("acrylic");
    acrylic.poisson_ratio = 0;
    acrylic.stiffness_damping = 0.02;
    const Vec3 size(0.4, kLength, 0.006);
    for (const double z : {0.0, -0.006 - kGap})
      scene.bodies.push_back(box("plate", size, Vec3(0, 0, z), acrylic, Vec3(0.1, 0.1, 0.006)));
    for (BodyDescription& plate : scene.bodies)
      plate.supports = {held(HalfSpaceRegion{Vec3(0, -kLength / 2, 0), -Vec3::UnitY()})};
    scene.bodies[0].loads = {{.region = BoxRegion{Vec3(-1, -1, 0.0029), Vec3(1, 1, 0.0031)},
                              .kind = LoadKind::traction,
                              .traction = -kTraction * Vec3::UnitZ(),
                              .ramp = 0.5}};
    World world(scene);
    testing::run_to(world, 3);
    double lowest = 0;
    for (const Vec3& position : world.frame().nodes.positions) lowest = std::min(lowest, position.z());
    const double stiffness = acrylic.young_modulus * std::pow(size.z(), 3) / 12;  // per width
    const double alone = kTraction * std::pow(kLength, 4) / (8 * stiffness);
    const double tip = lowest + 1.5 * size.z() + kGap;
    EXPECT_NEAR(-tip, (alone - kGap) / 2, 0.05 * (alone - kGap) / 2) << "1/" << rate << " s";
  }
}

// A hammer on rails meets a clamped pane at 10 m/s. Newton: it gives the pane at most the momentum of an elastic
// impact on half of its mass, and goes on through it.
TEST(SupportedPairs, AHammerOnRailsGoesThroughAPaneAtAnyStep) {
  for (const double rate : {30.0, 60.0, 250.0}) {
    Scene scene = weightless_scene(rate);
    scene.simulation.fracture = true;
    scene.bodies = {box("pane", Vec3(0.6, 0.6, 0.006), Vec3::Zero(), preset("soda_lime_glass"), Vec3(0.1, 0.1, 0.006)),
                    box("hammer", Vec3::Constant(0.1), Vec3(0, 0, 0.2), preset("mild_steel"), Vec3::Constant(0.1))};
    for (const Vec3& side : {Vec3(1, 0, 0), Vec3(-1, 0, 0), Vec3(0, 1, 0), Vec3(0, -1, 0)})
      scene.bodies[0].supports.push_back(held(HalfSpaceRegion{0.3 * side, side}));
    scene.bodies[1].velocity = -10 * Vec3::UnitZ();
    scene.bodies[1].supports = {on_rail(everywhere(), Vec3::UnitX()), on_rail(everywhere(), Vec3::UnitY())};
    World world(scene);
    testing::run_to(world, 0.1);
    const BodyView& hammer = world.frame().bodies[1];
    EXPECT_GT(-hammer.velocity.z(), 7.5) << "1/" << rate << " s";
    EXPECT_LT(-hammer.velocity.z(), 9.5) << "1/" << rate << " s";
    EXPECT_LT(hammer.center_of_mass.z(), -0.5) << "1/" << rate << " s";
    EXPECT_LT(testing::fraction_unaccounted(world.frame().energy), 0.01) << "1/" << rate << " s";
  }
}

/// A bar of steel on a hinge, whose free end comes down on a block of granite at `speed` [m/s].
Scene hinged_hammer(double rate, double speed, bool is_held) {
  Scene scene = weightless_scene(rate);
  scene.simulation.fracture = true;
  scene.bodies = {box("hammer", Vec3(0.1, 0.1, 1.2), Vec3(0, 0.2, -0.5), preset("mild_steel"), Vec3::Constant(0.05)),
                  box("block", Vec3(0.1, 0.08, 0.1), Vec3(0, 0.09, 0), preset("granite"), Vec3::Constant(0.04))};
  scene.bodies[0].supports = {
      {.region = BoxRegion{Vec3(-1, -1e-3, -0.5001), Vec3(1, 1e-3, -0.4999)}, .can_tear = false}};
  scene.bodies[0].angular_velocity = Vec3(speed, 0, 0);
  scene.bodies[0].velocity = Vec3(0, -0.5 * speed, 0);
  if (is_held) scene.bodies[1].supports = {held(HalfSpaceRegion{Vec3(0, -0.04, 0), -Vec3::UnitY()})};
  return scene;
}

// The hammer keeps its speed but for what a block of 2 kg takes from 31 kg at its end, and breaks it.
TEST(SupportedPairs, AHingedHammerStrikesAtAnyStep) {
  for (const bool is_held : {false, true})
    for (const double speed : {4.0, 6.0})
      for (const double rate : {30.0, 60.0, 250.0}) {
        World world(hinged_hammer(rate, speed, is_held));
        const double energy = world.frame().totals.kinetic_energy;
        testing::run_to(world, 2.0 / 30);
        const auto at = ::testing::Message() << is_held << ", " << speed << " m/s, 1/" << rate;
        EXPECT_GT(world.frame().bodies.size(), is_held || speed > 4 ? 4u : 1u) << at;
        const double left = world.frame().totals.kinetic_energy / energy;
        EXPECT_LT(left, is_held ? 0.8 : 1) << at;
        EXPECT_GT(left, is_held ? 0 : 0.85) << at;
        EXPECT_LT(testing::fraction_unaccounted(world.frame().energy), 0.01) << at;
      }
}

// Neighbors whose feet are held side by side, touching or 4 mm inside one another, press on nothing.
TEST(SupportedPairs, NeighborsStandStill) {
  for (const double distance : {0.3, 0.296}) {
    Scene scene;
    for (const double x : {0.0, distance}) {
      scene.bodies.push_back(box("wall", Vec3(0.3, 1, 0.3), Vec3(x, 0.5, 0), preset("brick"), Vec3::Constant(0.1)));
      scene.bodies.back().supports = {held(HalfSpaceRegion{Vec3(0, -0.5, 0), -Vec3::UnitY()})};
    }
    World world(scene);
    const std::vector<Vec3> before = testing::positions_of(world.frame());
    testing::run_to(world, 1);
    EXPECT_LT(testing::farthest_moved(before, world.frame()), 1e-6);
    EXPECT_TRUE(world.frame().crack_events.empty());
    EXPECT_TRUE(testing::all_asleep(world.frame()));
  }
}

}  // namespace
}  // namespace griffith
