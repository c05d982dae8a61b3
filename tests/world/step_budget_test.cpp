#include <gtest/gtest.h>

#include <algorithm>

#include "sim/world/world.h"
#include "tests/world/scenes.h"

namespace griffith {
namespace {

/// A pane held all round.
Scene held_pane(double time_step, double step_budget) {
  Scene scene = testing::shot_pane(7, time_step);
  scene.simulation.step_budget = step_budget;
  for (const Vec3& side : {Vec3(1, 0, 0), Vec3(-1, 0, 0), Vec3(0, 1, 0), Vec3(0, -1, 0)})
    scene.bodies[0].supports.push_back({HalfSpaceRegion{0.5 * side, side}});
  return scene;
}

struct Shot {
  int bodies = 0, most_substeps = 0, coarse_substeps = 0;
  double speed = 0;  ///< of the ball, after 0.1 s [m/s]
};

Shot shoot(const Scene& scene) {
  World world(scene);
  Shot shot;
  while (world.frame().time < 0.1) {
    world.step();
    shot.most_substeps = std::max(shot.most_substeps, world.frame().report.substeps);
    shot.coarse_substeps += world.frame().report.coarse_substeps;
  }
  shot.bodies = static_cast<int>(world.frame().bodies.size());
  shot.speed = -world.frame().projectiles[0].velocity.z();
  return shot;
}

TEST(StepBudget, WithEnoughOfItABallGoesThroughAPaneAsFastAtLongSteps) {
  const Shot fine = shoot(held_pane(1.0 / 2000, 1000)), coarse = shoot(held_pane(1.0 / 60, 1000));
  EXPECT_GT(fine.speed, 12);
  EXPECT_NEAR(coarse.speed, fine.speed, 0.2 * fine.speed);
  EXPECT_GT(coarse.bodies, fine.bodies / 2);
  EXPECT_LT(coarse.bodies, fine.bodies * 2);
}

TEST(StepBudget, ASmallOneMakesFewSubstepsAndSaysSo) {
  const Shot small = shoot(held_pane(1.0 / 60, 1)), large = shoot(held_pane(1.0 / 60, 1000));
  EXPECT_LE(small.most_substeps, 3);
  EXPECT_GT(small.coarse_substeps, 0);
  EXPECT_GT(large.most_substeps, 10);
}

}  // namespace
}  // namespace griffith
