// A step does a bounded amount of work, on meshes with slivers and small elements too.

#include <gtest/gtest.h>

#include "sim/core/parallel.h"
#include "sim/mesh/box_mesh.h"
#include "sim/world/output/step_counters.h"
#include "sim/world/world.h"
#include "tests/random_values.h"

namespace griffith {
namespace {

constexpr double kCeiling = 50;  ///< ceiling with small budgets [ms on a typical core]

/// A cube whose corners are pushed toward the faces opposite them in every tenth tet, which makes those flat.
TetSoup cube_with_slivers() {
  testing::RandomValues random(3);
  TetSoup soup = make_box(Vec3::Ones(), Vec3::Constant(0.125), BoxPattern::five_tet);
  for (const auto& tet : soup.tets) {
    if (random.index(10) > 0) continue;
    const Vec3 middle = (soup.points[tet[1]] + soup.points[tet[2]] + soup.points[tet[3]]) / 3;
    Vec3& corner = soup.points[tet[0]];
    const Vec3 before = corner;
    corner = middle + random.uniform(0.03, 0.3) * (corner - middle);
    for (const auto& other : soup.tets) {
      const Vec3 &a = soup.points[other[0]], b = soup.points[other[1]], c = soup.points[other[2]];
      if ((b - a).cross(c - a).dot(soup.points[other[3]] - a) > 1e-7) continue;
      corner = before;  // it would turn a neighbor inside out
      break;
    }
  }
  return soup;
}

/// Thrown at the ground.
Scene thrown_cube(double budget) {
  Scene scene;
  scene.ground = Ground{};
  scene.simulation.time_step = 1.0 / 60;
  scene.simulation.step_budget = budget;
  BodyDescription cube;
  cube.shape = MeshFileShape{"cube"};
  cube.position = Vec3(0, 0.95, 0);
  cube.rotation_degrees = Vec3(25, 0, 25);
  cube.velocity = Vec3(0, -10, 0);
  cube.material = *find_material_preset("concrete");
  scene.bodies = {cube};
  return scene;
}

TEST(WorkCeiling, HoldsInEveryStepAndIsReported) {
  World world(thrown_cube(0.1), InMemoryMeshes{{"cube", cube_with_slivers()}});
  StepReport total;
  for (int step = 0; step < 30; ++step) {
    world.step();
    const Frame frame = world.frame();
    EXPECT_LE(frame.report.microstep_work, 1.05 * kCeiling) << step;
    EXPECT_EQ(frame.report.non_finite_values, 0);
    add_step(frame.report, total);
  }
  EXPECT_GT(total.unfinished_explicit, 0) << "the ceiling was reached";
  EXPECT_GT(total.relieved_tets, 0);
}

TEST(WorkCeiling, CutsNothingWhereTheBudgetIsLarge) {
  World world(thrown_cube(1000), InMemoryMeshes{{"cube", cube_with_slivers()}});
  StepReport total;
  for (int step = 0; step < 2; ++step) {
    world.step();
    add_step(world.frame().report, total);
  }
  EXPECT_GT(world.frame().crack_events.size(), 100u);
  EXPECT_GT(total.microstep_work, kCeiling) << "a small budget would have cut it short";
  EXPECT_EQ(total.unfinished_explicit, 0);
}

/// A substep that takes too much work is repeated, shorter, with the same bits.
TEST(WorkCeiling, TheNumberOfThreadsChangesNoBit) {
  std::vector<std::uint64_t> hashes;
  for (const int threads : {1, 2, 4}) {
    const ThreadLimit limit(threads);
    World world(thrown_cube(0.1), InMemoryMeshes{{"cube", cube_with_slivers()}});
    for (int step = 0; step < 6; ++step) world.step();
    hashes.push_back(world.state_hash());
  }
  EXPECT_EQ(hashes[1], hashes[0]);
  EXPECT_EQ(hashes[2], hashes[0]);
}

/// Pane of glass of 6 mm on four fixed edges, and a ball of 5 kg above it that falls at 10 m/s.
Scene ball_above_pane(BoxPattern pattern) {
  constexpr double kWidth = 0.6;
  Scene scene;
  scene.ground.reset();
  scene.simulation.step_budget = 1;
  BodyDescription pane;
  pane.shape = BoxShape{Vec3(kWidth, 0.006, kWidth), Vec3(0.1, 0.006, 0.1), pattern};
  pane.material = *find_material_preset("soda_lime_glass");
  for (const Vec3& outward : {Vec3(1, 0, 0), Vec3(-1, 0, 0), Vec3(0, 0, 1), Vec3(0, 0, -1)})
    pane.supports.push_back({HalfSpaceRegion{(0.5 * kWidth - 1e-3) * outward, outward}});
  scene.bodies = {pane};
  ProjectileBurst ball;
  ball.position = Vec3(0.013, 0.058, 0.007), ball.direction = -Vec3::UnitY();
  ball.speed = 10, ball.mass = 5, ball.radius = 0.053;
  scene.projectiles = {ball};
  return scene;
}

/// The rest of a step after its ceiling has no microsteps. The faces beside the hole must not stop the ball: the pane
/// takes less than a fifth of its momentum at any budget.
TEST(WorkCeiling, ABallGoesOnThroughAPane) {
  for (const auto& [pattern, rate] :
       {std::pair(BoxPattern::kuhn, 30), std::pair(BoxPattern::five_tet, 30), std::pair(BoxPattern::kuhn, 60)}) {
    Scene scene = ball_above_pane(pattern);
    scene.simulation.time_step = 1.0 / rate;
    World world(scene);
    for (int step = 0; step < rate / 10; ++step) world.step();
    EXPECT_GT(-world.frame().projectiles[0].velocity.y(), 8) << rate;
    EXPECT_LT(std::abs(world.frame().energy.unaccounted()), 0.01 * world.frame().energy.turned_over());
  }
}

}  // namespace
}  // namespace griffith
