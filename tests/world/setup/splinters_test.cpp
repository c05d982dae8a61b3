#include <gtest/gtest.h>

#include "sim/core/error.h"
#include "sim/core/parallel.h"
#include "sim/world/setup/build_world.h"
#include "sim/world/setup/place_splinters.h"
#include "sim/world/state/world_state.h"
#include "sim/world/world.h"
#include "tests/world/scenes.h"

namespace griffith {
namespace {

Scene bricks(double strength) {
  Scene scene = testing::shot_wall(Vec3(2, 2, 0.5), 0.5, testing::brick(strength));
  BrickSplinters pattern;
  pattern.size = Vec3(0.4, 0.2, 0.25);
  pattern.mortar = 0;
  pattern.origin = Vec3(-1, -1, -0.25);
  scene.bodies[0].splinters = pattern;
  return scene;
}

TEST(WorldSplinters, DoNotInfluenceTheSimulation) {
  Scene plain = bricks(0.02);
  plain.bodies[0].splinters.reset();
  World with(bricks(0.02)), without(plain);
  for (int i = 0; i < 30; ++i) with.step(), without.step();
  EXPECT_EQ(with.state_hash(), without.state_hash());
  EXPECT_GT(with.frame().fragments, 0);
}

TEST(WorldSplinters, AnUnbrokenRunOpensNoWall) {
  World world(bricks(1e6));
  for (int i = 0; i < 20; ++i) world.step();
  EXPECT_TRUE(world.frame().splinters.open_walls.empty());
  EXPECT_FALSE(world.frame().splinters.splinters.empty());
}

/// After every step each splinter is in one body, that of its owner, and what carries it belongs to that body.
TEST(WorldSplinters, BelongToTheBodyOfTheirOwner) {
  World world(bricks(0.02));
  for (int i = 0; i < 40; ++i) {
    world.step();
    const Frame frame = world.frame();
    std::vector<bool> open(frame.splinters.faces.size(), false);
    for (const int face : frame.splinters.open_walls) open[face] = true;
    const auto body = [&](int part) {
      return frame.elements.bodies[frame.splinters.splinters[frame.splinters.parts[part].splinter].owner];
    };
    for (std::size_t p = 0; p < frame.splinters.parts.size(); ++p)
      if (frame.splinters.attached[p]) {
        EXPECT_EQ(frame.elements.bodies[frame.splinters.parts[p].tet], body(static_cast<int>(p)));
      }
    for (std::size_t f = 0; f < frame.splinters.faces.size(); ++f) {
      const SplinterFace& face = frame.splinters.faces[f];
      EXPECT_TRUE(open[f] || face.beyond < 0 || body(face.part) == body(face.beyond));
    }
  }
  EXPECT_GT(world.frame().fragments, 5);
  EXPECT_FALSE(world.frame().splinters.open_walls.empty());
}

TEST(WorldSplinters, AreTheSameForAnyNumberOfThreads) {
  std::vector<std::vector<int>> opened;
  for (const int threads : {1, 2}) {
    const ThreadLimit limit(threads);
    World world(bricks(0.02));
    for (int i = 0; i < 20; ++i) world.step();
    const Frame frame = world.frame();
    opened.emplace_back(frame.splinters.open_walls.begin(), frame.splinters.open_walls.end());
  }
  EXPECT_EQ(opened[0], opened[1]);
}

TEST(WorldSplinters, APatternThatCannotBeMadeIsNamed) {
  Scene scene = bricks(1);
  VoronoiSplinters dust;
  dust.size = 1e-4;
  scene.bodies[0].splinters = dust;
  try {
    World world(scene);
    FAIL();
  } catch (const InputError& error) {
    EXPECT_EQ(error.where(), "#/bodies/0/splinters");
  }
}

TEST(WorldSplinters, TheLimitHoldsForAllBodiesTogether) {
  const WorldState built = build_world(bricks(1));
  Model model = *built.model;
  model.splinters.splinters.resize(static_cast<std::size_t>(kMaxSplinterCells) - 10);  // as of other bodies
  const TetSoup soup;
  const std::vector<int> points;
  try {
    place_splinters(model, 0, {soup, points, built.mesh, {}}, {});
    FAIL();
  } catch (const InputError& error) {
    EXPECT_EQ(error.where(), "#/bodies/0/splinters");
    EXPECT_EQ(error.problem(), "brings the scene to more than 2 million splinters");
  }
}

}  // namespace
}  // namespace griffith
