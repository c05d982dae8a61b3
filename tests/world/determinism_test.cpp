#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <vector>

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

TEST(ParallelParts, AreAsManyAsThreadsAndCoverAllOnce) {
  for (const int threads : {1, 2, 4})
    for (const int count : {0, 1, 99, 100, 250, 1001}) {
      const ThreadLimit limit(threads);
      std::vector<int> visits(count, 0);
      std::atomic<int> parts = 0;
      parallel_parts(count, 100, [&](int begin, int end) {
        EXPECT_GE(end - begin, std::min(count, 100));
        for (int i = begin; i < end; ++i) ++visits[i];
        ++parts;
      });
      EXPECT_EQ(parts, count == 0 ? 0 : std::clamp(count / 100, 1, threads)) << count;
      EXPECT_EQ(std::ranges::count(visits, 1), count);
    }
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
