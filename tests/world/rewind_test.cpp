#include "sim/world/rewind.h"

#include <gtest/gtest.h>

#include "sim/parallel.h"
#include "sim/world/phases.h"
#include "sim/world/world.h"
#include "tests/world/scenes.h"

namespace griffith {
namespace {

using testing::brick;
using testing::struck_block;

/// Steps so long that cracks would run through the pane in one.
Scene quickly_shot_pane() { return testing::shot_pane(14, 1.0 / 60); }

TEST(Rewind, TakesAllThatMovesBack) {
  WorldState world(struck_block(brick(1e3)));
  build_world(world);
  while (world.contact_views.empty()) advance(world);
  const Moment moment = moment_of(world);
  advance(world);
  ASSERT_EQ(world.bodies.size(), 1u);
  EXPECT_NE(world.nodes.positions.front(), moment.positions.front());
  const Vec3 after = world.contact_world.state(world.projectiles[0].object).velocity;

  rewind(world, moment, {});
  --world.step;
  EXPECT_EQ(world.time, moment.time);
  EXPECT_EQ(world.nodes.positions, moment.positions);
  EXPECT_EQ(world.nodes.velocities, moment.velocities);
  EXPECT_EQ(world.bodies[BodyId(0)].motion.center, moment.pieces[0].motion.center);
  const RigidState ball = world.contact_world.state(world.projectiles[0].object);
  EXPECT_EQ(ball.pose.translation, moment.projectiles[0].pose.translation);
  EXPECT_EQ(ball.velocity, moment.projectiles[0].velocity);

  advance(world);
  EXPECT_LT((world.contact_world.state(world.projectiles[0].object).velocity - after).norm(),
            1e-4 * ProjectileBurst().speed);  // as far as contacts are solved, from another guess
}

TEST(Rewind, RepeatedSubstepsKeepMomentumAndMakeNoEnergy) {
  World world(quickly_shot_pane());
  world.step();
  const Totals first = world.frame().totals;
  const double whole = first.kinetic_energy + first.elastic_energy;
  double energy = whole;
  int repeated = 0;
  for (int i = 0; i < 60; ++i) {
    world.step();
    const Totals& now = world.frame().totals;
    repeated += world.frame().report.repeated_substeps;
    EXPECT_LT((now.momentum - first.momentum).norm(), 1e-6 * first.momentum.norm());
    EXPECT_LE(now.kinetic_energy + now.elastic_energy, energy + 2e-3 * whole);
    energy = now.kinetic_energy + now.elastic_energy;
  }
  EXPECT_GT(repeated, 0);
  EXPECT_GT(world.frame().bodies.size(), 20u);
}

TEST(Rewind, TheSameBitsForAnyNumberOfThreads) {
  std::vector<std::vector<Vec3>> positions;
  for (int threads : {1, 2, 4}) {
    const ThreadLimit limit(threads);
    World world(quickly_shot_pane());
    int repeated = 0;
    for (int i = 0; i < 6; ++i) {
      world.step();
      repeated += world.frame().report.repeated_substeps;
    }
    EXPECT_GT(repeated, 0);
    const auto now = world.frame().positions;
    positions.emplace_back(now.begin(), now.end());
  }
  EXPECT_EQ(positions[0], positions[1]);
  EXPECT_EQ(positions[0], positions[2]);
}

}  // namespace
}  // namespace griffith
