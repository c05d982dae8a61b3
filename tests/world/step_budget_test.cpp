#include <gtest/gtest.h>

#include "sim/world/world.h"

namespace griffith {
namespace {

/// A pane held all round and a heavy ball, in weightless space.
Scene shot_pane(double time_step, double step_budget) {
  Scene scene;
  scene.gravity.setZero();
  scene.ground.reset();
  scene.simulation.time_step = time_step;
  scene.simulation.step_budget = step_budget;
  BodyDescription pane;
  pane.shape = BoxShape{Vec3(1, 1, 0.02), Vec3(1.0 / 7, 1.0 / 7, 0.02), BoxPattern::five_tet};
  pane.material.young_modulus = 7e8;
  pane.material.density = 2500;
  pane.material.tensile_strength = 2e6;
  pane.material.fracture_toughness = 7.6e4;
  for (const Vec3& side : {Vec3(1, 0, 0), Vec3(-1, 0, 0), Vec3(0, 1, 0), Vec3(0, -1, 0)})
    pane.supports.push_back({HalfSpaceRegion{0.5 * side, side}});
  scene.bodies = {pane};
  ProjectileBurst shot;
  shot.position = Vec3(0.05, 0.08, 0.5);
  shot.speed = 25;
  shot.mass = 20;
  shot.radius = 0.085;
  scene.projectiles = {shot};
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
  const Shot fine = shoot(shot_pane(1.0 / 2000, 1000)), coarse = shoot(shot_pane(1.0 / 60, 1000));
  EXPECT_GT(fine.speed, 12);
  EXPECT_NEAR(coarse.speed, fine.speed, 0.2 * fine.speed);
  EXPECT_GT(coarse.bodies, fine.bodies / 2);
  EXPECT_LT(coarse.bodies, fine.bodies * 2);
}

TEST(StepBudget, ASmallOneMakesFewSubstepsAndSaysSo) {
  const Shot small = shoot(shot_pane(1.0 / 60, 1)), large = shoot(shot_pane(1.0 / 60, 1000));
  EXPECT_LE(small.most_substeps, 3);
  EXPECT_GT(small.coarse_substeps, 0);
  EXPECT_GT(large.most_substeps, 10);
}

}  // namespace
}  // namespace griffith
