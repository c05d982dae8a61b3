#include <gtest/gtest.h>

#include "sim/core/parallel.h"
#include "sim/world/world.h"
#include "tests/world/scenes.h"

namespace griffith {
namespace {

using testing::brick;
using testing::shot_wall;

/// A wall fine enough that loops over nodes and tets run in parallel, and weak enough to shatter.
std::uint64_t hash_after(int steps, int threads, double element_size = 0.5) {
  const ThreadLimit limit(threads);
  World world(shot_wall(Vec3(6, 6, 1), element_size, brick(0.02)));
  for (int i = 0; i < steps; ++i) world.step();
  EXPECT_GT(world.frame().crack_events.size(), 0u);
  return world.state_hash();
}

TEST(Determinism, TheSameBitsForOneTwoAndFourThreads) {
  const std::uint64_t one = hash_after(16, 1);
  EXPECT_EQ(hash_after(16, 2), one);
  EXPECT_EQ(hash_after(16, 4), one);
}

TEST(Determinism, TheSameBitsWhereThreadsShareTheNodesOfABody) {
  constexpr double kFine = 0.25;  // 3,125 nodes
  const std::uint64_t one = hash_after(16, 1, kFine);
  EXPECT_EQ(hash_after(16, 2, kFine), one);
  EXPECT_EQ(hash_after(16, 4, kFine), one);
}

TEST(Determinism, TheHashSeesTheSmallestChange) {
  Scene scene = shot_wall(Vec3(3, 3, 1), 1.5, brick(1));
  scene.simulation.static_start = false;
  World a(scene);
  Scene other = scene;
  other.bodies[0].material.young_modulus *= 1 + 1e-12;
  World b(other);
  EXPECT_EQ(a.state_hash(), b.state_hash()) << "nothing has moved yet";
  a.step();
  b.step();
  EXPECT_NE(a.state_hash(), b.state_hash());
}

}  // namespace
}  // namespace griffith
