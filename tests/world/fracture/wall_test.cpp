#include <gtest/gtest.h>

#include <cmath>

#include "sim/scene/scene_reader.h"
#include "sim/world/world.h"

namespace griffith {
namespace {

constexpr int kSteps = 300;

Scene wall_scene(const std::string& name, double strength) {
  Scene scene = read_scene(std::string(GRIFFITH_SOURCE_DIR) + "/scenes/" + name + ".json");
  for (BodyDescription& body : scene.bodies) {
    body.material.tensile_strength *= strength;
    body.material.fracture_toughness *= strength;
  }
  return scene;
}

bool finite(const Frame& frame) {
  for (const Vec3& position : frame.nodes.positions)
    if (!position.allFinite()) return false;
  for (const Vec3& velocity : frame.nodes.velocities)
    if (!velocity.allFinite()) return false;
  for (const Mat3& stress : frame.elements.stresses)
    if (!stress.allFinite()) return false;
  return true;
}

double body_mass(const Frame& frame) {
  double mass = 0;
  for (double m : frame.nodes.masses) mass += m;
  return mass;
}

/// Runs a wall and checks what must hold in every step. Returns the number of pieces at the end.
std::size_t shoot(const Scene& scene) {
  World world(scene);
  const double mass = body_mass(world.frame());
  for (int step = 0; step < kSteps; ++step) {
    world.step();
    const Frame frame = world.frame();
    EXPECT_TRUE(finite(frame)) << "step " << step;
    EXPECT_EQ(frame.report.non_finite_values, 0) << "step " << step;
    EXPECT_EQ(frame.report.unconverged_solves, 0) << "step " << step;
    EXPECT_NEAR(body_mass(frame), mass, 1e-12 * mass) << "step " << step;
    if (::testing::Test::HasFailure()) break;
  }
  EXPECT_EQ(world.frame().projectiles.size(), 3u);
  return world.frame().bodies.size();
}

class PaperWall : public ::testing::TestWithParam<const char*> {};

TEST_P(PaperWall, BreaksWhenWeakAndStandsWhenStrong) {
  EXPECT_GT(shoot(wall_scene(GetParam(), 0.5)), 1u);
  EXPECT_EQ(shoot(wall_scene(GetParam(), 50)), 1u);
}

TEST_P(PaperWall, StandsUndisturbedUnderItsOwnWeight) {
  Scene scene = wall_scene(GetParam(), 1);
  scene.projectiles.clear();
  World world(scene);
  for (int step = 0; step < kSteps; ++step) world.step();
  const Frame frame = world.frame();
  EXPECT_EQ(frame.bodies.size(), 1u);
  EXPECT_EQ(frame.crack_events.size(), 0u);
  for (std::size_t i = 0; i < frame.nodes.positions.size(); ++i)
    EXPECT_LT((frame.nodes.positions[i] - frame.nodes.rest_positions[i]).norm(), 1e-3);
}

INSTANTIATE_TEST_SUITE_P(Scenes, PaperWall, ::testing::Values("wall_small", "wall_medium", "wall_large"));

TEST(Wall, CracksAreEventsAndPiecesHaveParents) {
  World world(wall_scene("wall_small", 0.5));
  for (int step = 0; step < 60; ++step) world.step();
  const Frame frame = world.frame();
  ASSERT_GT(frame.crack_events.size(), 0u);
  EXPECT_EQ(frame.fragments + 1, static_cast<int>(frame.bodies.size()));
  for (const CrackEvent& event : frame.crack_events) {
    EXPECT_GT(event.load, event.resistance);
    EXPECT_NEAR(event.normal.norm(), 1, 1e-9);
    EXPECT_LT(event.step, frame.step);
  }
  double mass = 0;
  for (const BodyView& body : frame.bodies) {
    EXPECT_EQ(body.parent.valid(), body.id != BodyId(0));
    EXPECT_GT(body.tets, 0);
    mass += body.mass;
  }
  EXPECT_NEAR(mass, body_mass(frame), 1e-9 * mass);
}

TEST(Wall, TheForceCriterionBreaksItToo) {
  Scene scene = wall_scene("wall_small", 1);
  Material& material = scene.bodies[0].material;
  material.criterion = FractureCriterion::separation_force;
  material.separation_toughness = 3e4;
  World weak(scene);
  material.separation_toughness = 1e9;
  World strong(scene);
  for (int step = 0; step < 100; ++step) {
    weak.step();
    strong.step();
  }
  EXPECT_GT(weak.frame().bodies.size(), 1u);
  EXPECT_EQ(strong.frame().bodies.size(), 1u);
}

TEST(Wall, NeverFracturesWhenFractureIsOff) {
  Scene scene = wall_scene("wall_small", 0.01);
  scene.simulation.fracture = false;
  World world(scene);
  for (int step = 0; step < 60; ++step) world.step();
  EXPECT_EQ(world.frame().bodies.size(), 1u);
}

TEST(Wall, PostponesCracksOverTheBudget) {
  Scene scene = wall_scene("wall_small", 0.2);
  scene.simulation.max_cracks_per_step = 1;
  World world(scene);
  int postponed = 0;
  for (int step = 0; step < 100; ++step) {
    world.step();
    EXPECT_LE(world.frame().report.cracks, 1);
    postponed += world.frame().report.cracks_postponed;
  }
  EXPECT_GT(postponed, 0);
  EXPECT_GT(world.frame().bodies.size(), 1u);
}

}  // namespace
}  // namespace griffith
