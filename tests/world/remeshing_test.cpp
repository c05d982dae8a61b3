#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "sim/mesh/mesh_report.h"
#include "sim/mesh/topology.h"
#include "sim/parallel.h"
#include "sim/world/world.h"
#include "tests/world/scenes.h"

namespace griffith {
namespace {

using testing::brick;
using testing::shot_wall;
using testing::struck_block;

Scene remeshed(Scene scene) {
  for (BodyDescription& body : scene.bodies) body.remeshing = true;
  return scene;
}

double volume(const Frame& frame) {
  double sum = 0;
  for (const auto& [a, b, c, d] : frame.tets) {
    const auto& x = frame.rest_positions;
    sum += signed_volume(x[a], x[b], x[c], x[d]);
  }
  return sum;
}

TEST(Remeshing, MomentumIsKeptThroughAnImpactThatCutsABlock) {
  World world(remeshed(struck_block(brick(0.1))));
  const std::size_t tets = world.frame().tets.size();
  const double initial_volume = volume(world.frame());
  world.step();  // the sphere is launched
  const Totals before = world.frame().totals;
  for (int step = 0; step < 120; ++step) {
    world.step();
    const Totals now = world.frame().totals;
    ASSERT_NEAR(now.mass, before.mass, 1e-9 * before.mass);
    ASSERT_LT((now.momentum - before.momentum).norm(), 1e-6 * before.momentum.norm()) << "step " << step;
    ASSERT_LT((now.angular_momentum - before.angular_momentum).norm(), 1e-2 * before.angular_momentum.norm())
        << "step " << step;
    ASSERT_LE(now.kinetic_energy + now.elastic_energy, before.kinetic_energy * (1 + 1e-6)) << "step " << step;
    ASSERT_EQ(world.frame().report.non_finite_values, 0);
  }
  EXPECT_GT(world.frame().bodies.size(), 1u) << "it did break";
  EXPECT_GT(world.frame().tets.size(), tets) << "tets were cut";
  EXPECT_NEAR(volume(world.frame()), initial_volume, 1e-9 * initial_volume);
  printf("tets %zu -> %zu, bodies %zu\n", tets, world.frame().tets.size(), world.frame().bodies.size());
}

TEST(Remeshing, AWallThatIsShotKeepsItsInvariantsOnAnyNumberOfThreads) {
  const Scene scene = remeshed(shot_wall(Vec3(1.5, 1.5, 0.25), 0.25, brick(0.3)));
  std::vector<std::uint64_t> hashes;
  for (int threads : {1, 2, 4}) {
    const ThreadLimit limit(threads);
    World world(scene);
    const std::size_t tets = world.frame().tets.size();
    int refused = 0;
    for (int step = 0; step < 60; ++step) {
      world.step();
      refused += world.frame().report.remeshing_refused;
      ASSERT_EQ(world.frame().report.non_finite_values, 0);
    }
    hashes.push_back(world.state_hash());
    const Frame frame = world.frame();
    EXPECT_GT(frame.fragments, 0);
    EXPECT_GT(frame.tets.size(), tets);
    for (const auto& [a, b, c, d] : frame.tets) {
      const auto& x = frame.rest_positions;
      ASSERT_GE(tet_quality(x[a], x[b], x[c], x[d]), 0.1);
    }
    printf("tets %zu -> %zu, bodies %zu, cracks %zu refused %d\n", tets, frame.tets.size(), frame.bodies.size(), frame.crack_events.size(), refused);
  }
  EXPECT_THAT(hashes, ::testing::Each(hashes.front()));
}

/// Nodes at the wall's foot are those that its support holds, however it is cut.
TEST(Remeshing, SupportsHoldTheMiddleOfAnEdgeWhereTheyHoldBothEnds) {
  World world(remeshed(shot_wall(Vec3(1.5, 1.5, 0.25), 0.25, brick(0.1))));
  const std::size_t nodes = world.frame().positions.size();
  for (int step = 0; step < 60; ++step) world.step();
  const Frame frame = world.frame();
  ASSERT_GT(frame.positions.size(), nodes);
  int held = 0, new_ones = 0;
  for (std::size_t node = 0; node < frame.positions.size(); ++node) {
    if (!frame.node_held[node]) continue;
    ++held;
    new_ones += node >= nodes;
    EXPECT_LT(frame.rest_positions[node].y(), 1e-9);
    EXPECT_LT((frame.positions[node] - frame.rest_positions[node]).norm(), 1e-12);
  }
  EXPECT_GT(held, 0);
  printf("held %d new %d\n", held, new_ones);
}

/// A bar with loads on faces, tets and nodes that breaks in weightless space.
TEST(Remeshing, LoadsStayOnTheirMaterial) {
  Scene scene;
  scene.gravity.setZero();
  scene.ground.reset();
  scene.simulation.max_cracks_per_step = 4;
  BodyDescription bar;
  bar.shape = BoxShape{Vec3(2, 0.5, 0.5), Vec3::Constant(0.25), BoxPattern::five_tet};
  bar.material = brick(0.01);
  bar.remeshing = true;
  const HalfSpaceRegion everything{Vec3::Zero(), Vec3::UnitX()}, end{Vec3(1, 0, 0), Vec3::UnitX()},
      other_end{Vec3(-1, 0, 0), -Vec3::UnitX()};
  const double area = 0.25;
  Load traction{.region = end, .kind = LoadKind::traction, .traction = Vec3(2e5, 0, 0)};
  Load pull{.region = other_end, .kind = LoadKind::point_force, .force = Vec3(-3e4, 0, 0)};
  Load push{.region = everything, .kind = LoadKind::body_force, .acceleration = Vec3(0, 5, 0)};
  bar.loads = {traction, pull, push};
  scene.bodies = {bar};
  World world(scene);
  const std::size_t tets = world.frame().tets.size();
  const double half_mass = world.frame().totals.mass / 2;
  const int steps = 30;
  for (int step = 0; step < steps; ++step) world.step();
  EXPECT_GT(world.frame().tets.size(), tets);
  EXPECT_GT(world.frame().fragments, 0);
  const double time = steps * scene.simulation.time_step;
  const Vec3 impulse = time * (area * traction.traction + pull.force + half_mass * push.acceleration);
  EXPECT_LT((world.frame().totals.momentum - impulse).norm(), 1e-6 * impulse.norm());
}

}  // namespace
}  // namespace griffith
