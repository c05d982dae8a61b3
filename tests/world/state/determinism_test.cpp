#include <gtest/gtest.h>

#include <string>
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
  const std::uint64_t one = hash_after(14, 1, kFine);
  EXPECT_EQ(hash_after(14, 2, kFine), one);
  EXPECT_EQ(hash_after(14, 4, kFine), one);
}

/// Walls that vibrate side by side, of which copies are kept, as a recording does: the first step after a copy writes
/// states that were shared so far.
std::vector<std::uint64_t> hashes_beside_copies(int threads) {
  const ThreadLimit limit(threads);
  Scene scene = shot_wall(Vec3(4, 4, 1), 0.25, brick(1));
  scene.simulation.static_start = false;
  scene.simulation.integrator = Integrator::implicit;
  scene.projectiles.clear();
  for (int i = 1; i < 4; ++i) {
    scene.bodies.push_back(scene.bodies[0]);
    scene.bodies[i].name += std::to_string(i);
    scene.bodies[i].position.x() = 5 * i;
  }
  World world(scene);
  std::vector<std::uint64_t> hashes;
  for (int step = 0; step < 4; ++step) {
    const World copy = world;
    world.step();
    for (const BodyView& body : world.frame().bodies) EXPECT_FALSE(body.rigid);
    hashes.push_back(world.state_hash());
  }
  return hashes;
}

TEST(Determinism, TheSameBitsWhileCopiesAreKept) {
  const std::vector<std::uint64_t> one = hashes_beside_copies(1);
  for (const int threads : {2, 4}) EXPECT_EQ(hashes_beside_copies(threads), one) << threads;
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
