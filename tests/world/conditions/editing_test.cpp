#include <gtest/gtest.h>

#include "sim/core/error.h"
#include "sim/world/world.h"
#include "tests/world/scenes.h"

namespace griffith {
namespace {

using testing::brick;
using testing::shot_wall;

Scene quiet_wall() {
  Scene scene = shot_wall(Vec3(3, 3, 1), 1.5, brick(1));
  scene.projectiles.clear();
  return scene;
}

TEST(Editing, ASofterMaterialSagsMore) {
  World stiff(quiet_wall()), edited(quiet_wall());
  Material soft = brick(1);
  soft.young_modulus = 1e8;
  edited.set_material(0, soft);
  for (int i = 0; i < 100; ++i) {
    stiff.step();
    edited.step();
  }
  const auto sag = [](const World& world) {
    double lowest = 0;
    const Frame frame = world.frame();
    for (std::size_t i = 0; i < frame.nodes.positions.size(); ++i)
      lowest = std::min(lowest, frame.nodes.positions[i].y() - frame.nodes.rest_positions[i].y());
    return -lowest;
  };
  EXPECT_GT(sag(edited), 50 * sag(stiff));
  EXPECT_EQ(edited.frame().materials[0].young_modulus, 1e8);
}

TEST(Editing, DensityChangesTheMassAndNotTheVelocities) {
  Scene scene = quiet_wall();
  scene.bodies[0].supports.clear();
  scene.bodies[0].position.y() = 20;
  scene.bodies[0].velocity = Vec3(1, 0, 0);
  World world(scene);
  const double mass = world.frame().totals.mass;
  Material heavy = brick(1);
  heavy.density *= 2;
  world.set_material(0, heavy);
  EXPECT_NEAR(world.frame().totals.mass, 2 * mass, 1e-9 * mass);
  world.step();
  EXPECT_NEAR(world.frame().bodies[0].velocity.x(), 1, 1e-9);
}

TEST(Editing, WeakeningAStandingWallBreaksItAtTheNextShot) {
  Scene scene = quiet_wall();
  World world(scene);
  for (int i = 0; i < 10; ++i) world.step();
  EXPECT_EQ(world.frame().bodies.size(), 1u);
  world.set_material(0, brick(0.02));
  world.fire(testing::shots(3));
  for (int i = 0; i < 60; ++i) world.step();
  EXPECT_GT(world.frame().projectiles.size(), 0u);
  EXPECT_GT(world.frame().bodies.size(), 1u);
}

TEST(Editing, UtilizationsFollowTheMaterialAtOnce) {
  World edited(quiet_wall());
  Scene scene = quiet_wall();
  scene.bodies[0].material = brick(0.5);
  const World made_so(scene);
  edited.set_material(0, brick(0.5));
  const Frame frame = edited.frame(), expected = made_so.frame();
  for (std::size_t i = 0; i < frame.nodes.separations.size(); ++i) {
    EXPECT_EQ(frame.nodes.separations[i].resistance, expected.nodes.separations[i].resistance);
    EXPECT_NEAR(frame.nodes.separations[i].utilization, expected.nodes.separations[i].utilization, 1e-6);
  }
}

TEST(Editing, CracksThatWerePutOffDoNotOpenInAStrongerMaterial) {
  Scene scene = shot_wall(Vec3(3, 3, 1), 0.5, brick(0.1));
  scene.simulation.max_cracks_per_step = 1;
  World world(scene);
  for (int i = 0; i < 60 && world.frame().report.cracks_postponed == 0; ++i) world.step();
  ASSERT_GT(world.frame().report.cracks_postponed, 0);
  const std::size_t cracks = world.frame().crack_events.size();
  world.set_material(0, brick(1e3));
  for (int i = 0; i < 10; ++i) world.step();
  EXPECT_EQ(world.frame().crack_events.size(), cracks);
}

TEST(Editing, ShotsLeaveAtTheirTime) {
  World world(quiet_wall());
  for (int i = 0; i < 12; ++i) world.step();
  ProjectileBurst burst = testing::shots(3);
  burst.start = 0;
  burst.interval = 0.1;  // 12 steps
  world.fire(burst);
  world.step();
  EXPECT_EQ(world.frame().projectiles.size(), 1u);
  for (int i = 0; i < 11; ++i) world.step();
  EXPECT_EQ(world.frame().projectiles.size(), 1u);
  world.step();
  EXPECT_EQ(world.frame().projectiles.size(), 2u);
}

TEST(Editing, AMeshThatIsMissingIsNamed) {
  Scene scene = quiet_wall();
  scene.bodies[0].shape = MeshFileShape{"no/such/mesh", 1};
  scene.folder = "/nowhere";
  try {
    World world(scene);
    FAIL() << "the mesh does not exist";
  } catch (const InputError& error) {
    EXPECT_EQ(error.where(), "#/bodies/0/shape/mesh");
    EXPECT_NE(error.problem().find("of \"wall\": /nowhere/no/such/mesh: no such file"), std::string::npos)
        << error.what();
  }
}

TEST(Editing, BeforeTheFirstStepIsAsIfMadeOfTheMaterial) {
  Scene scene = quiet_wall();
  BodyDescription free = scene.bodies[0];
  free.name = "free";
  free.supports.clear();
  free.position = Vec3(8, 20, 0);
  free.velocity = Vec3(1, 2, 3);
  free.angular_velocity = Vec3(0.1, 0.2, 0.3);
  scene.bodies.push_back(free);
  Material other = brick(1);
  other.young_modulus = 1e12;
  other.density *= 1.5;
  other.yield_strength = 1e5;
  World edited(scene);
  Material soft = brick(1);
  soft.young_modulus = 1e6;
  soft.yield_strength = 1;
  for (int body : {0, 1}) {
    edited.set_material(body, soft);
    edited.set_material(body, other);
    scene.bodies[body].material = other;
  }
  World made_so(scene);
  for (int step = 0; step < 3; ++step) {
    EXPECT_EQ(edited.state_hash(), made_so.state_hash()) << "step " << step;
    edited.step();
    made_so.step();
  }
}

/// 66 times the stiffness would be 66 times the stress if the wall kept its sag.
TEST(Editing, StiffeningAStandingWallBeforeTheFirstStepDoesNotCrackIt) {
  World world(quiet_wall());
  Material stiff = brick(1);
  stiff.young_modulus = 1e12;
  const double utilization = world.frame().report.peak_utilization;
  world.set_material(0, stiff);
  for (int step = 0; step < 10; ++step) {
    world.step();
    EXPECT_LT(world.frame().report.peak_utilization, 1.1 * utilization);
  }
  EXPECT_TRUE(world.frame().crack_events.empty());
}

}  // namespace
}  // namespace griffith
