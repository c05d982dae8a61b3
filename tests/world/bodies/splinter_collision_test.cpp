#include <gtest/gtest.h>

#include "sim/core/parallel.h"
#include "sim/world/bodies/collision_shape.h"
#include "sim/world/fracture/fracture_phase.h"
#include "sim/world/setup/build_world.h"
#include "sim/world/state/world_state.h"
#include "sim/world/step.h"
#include "sim/world/world.h"
#include "tests/world/scenes.h"

namespace griffith {
namespace {

VoronoiSplinters shards(double size) {
  VoronoiSplinters pattern;
  pattern.size = size;
  return pattern;
}

/// A block in weightless space whose splinters do not follow the plane in which it is cut.
Scene floating_block(double splinter_size = 0.2) {
  Scene scene;
  scene.gravity.setZero();
  scene.ground.reset();
  scene.bodies.resize(1);
  scene.bodies[0].shape = BoxShape{Vec3(1, 1, 1), Vec3::Constant(0.25), BoxPattern::five_tet};
  scene.bodies[0].splinters = shards(splinter_size);
  scene.bodies[0].collision = CollisionShape::splinters;
  return scene;
}

double volume_of(const std::vector<ConvexPart>& parts) {
  double volume = 0;
  for (const ConvexPart& part : parts) {
    Eigen::AlignedBox3d box;
    for (const Vec3& corner : part) box.extend(corner);
    volume += box.volume();
  }
  return volume;
}

/// Cuts all nodes of the plane y = 0 without any stress.
void cut_in_two(WorldState& world) {
  std::vector<NodeId> plane;
  for (const NodeId node : IdRange<NodeId>(0, world.mesh->node_count()))
    if (std::abs(world.mesh->rest_positions[node].y()) < 1e-9) plane.push_back(node);
  for (const NodeId node : plane) {
    world.nodes.separations[node].direction = Vec3::UnitY();
    world.nodes.separations[node].utilization = 2;
    open_cracks(world, 0);
    for (NodeSeparation& separation : world.nodes.separations) separation = {};
  }
}

TEST(SplinterCollision, AnIntactBlockTouchesWithItsWholeShape) {
  auto world = std::make_unique<WorldState>(build_world(floating_block()));
  const std::vector<ConvexPart> parts = collision_parts(*world, world->bodies[0]);
  EXPECT_EQ(parts.size(), 1u) << "what fills its hull is one part";
  EXPECT_NEAR(volume_of(parts), 1, 1e-6);
}

TEST(SplinterCollision, PiecesTouchWithTheSplintersThatTheyOwn) {
  auto world = std::make_unique<WorldState>(build_world(floating_block()));
  cut_in_two(*world);
  ASSERT_EQ(world->bodies.size(), 2u);
  for (const Body& body : world->bodies) {
    double lowest = 1, highest = -1;
    for (const ConvexPart& part : collision_parts(*world, body))
      for (const Vec3& corner : part) {
        lowest = std::min(lowest, corner.y() + body.motion.center.y());
        highest = std::max(highest, corner.y() + body.motion.center.y());
      }
    // Splinters reach across the plane of the cut; tets do not.
    if (body.motion.center.y() > 0) {
      EXPECT_LT(lowest, -0.005);
      EXPECT_NEAR(highest, 0.5, 1e-6);
    } else {
      EXPECT_GT(highest, 0.005);
      EXPECT_NEAR(lowest, -0.5, 1e-6);
    }
  }
}

TEST(SplinterCollision, ABodyCutInTwoAtRestStaysAtRest) {
  auto world = std::make_unique<WorldState>(build_world(floating_block()));
  cut_in_two(*world);
  ASSERT_EQ(world->bodies.size(), 2u);
  for (int step = 0; step < 100; ++step) advance(*world);
  EXPECT_LT(world->output.totals.kinetic_energy, 1e-20) << "no push apart, though the hulls overlap";
}

TEST(SplinterCollision, ManySplintersFallBackOnTheTets) {
  auto world = std::make_unique<WorldState>(build_world(floating_block(0.1)));
  EXPECT_NEAR(volume_of(collision_parts(*world, world->bodies[0])), 1, 1e-9);
}

/// A struck block: momentum of all that moves is kept, and energy never grows.
TEST(SplinterCollision, MomentumIsKeptAndNothingIsThrownOut) {
  Scene scene = testing::struck_block(testing::brick(0.02));
  scene.bodies[0].splinters = shards(0.25);
  scene.bodies[0].collision = CollisionShape::splinters;
  World world(scene);
  world.step();
  const Totals before = world.frame().totals;
  for (int i = 0; i < 60; ++i) {
    world.step();
    const Totals& now = world.frame().totals;
    ASSERT_LT((now.momentum - before.momentum).norm(), 1e-6 * before.momentum.norm());
    ASSERT_LT(now.kinetic_energy + now.elastic_energy, (1 + 1e-6) * before.kinetic_energy);
  }
  const Frame frame = world.frame();
  EXPECT_GT(frame.fragments, 5);
  const double ball_speed = scene.projectiles[0].speed;
  for (const BodyView& body : frame.bodies) EXPECT_LT(body.velocity.norm(), 2 * ball_speed);
}

TEST(SplinterCollision, IsTheSameForAnyNumberOfThreads) {
  std::vector<std::uint64_t> hashes;
  for (const int threads : {1, 2, 4}) {
    const ThreadLimit limit(threads);
    Scene scene = testing::shot_wall(Vec3(2, 2, 0.5), 0.5, testing::brick(0.05));
    scene.bodies[0].splinters = shards(0.3);
    scene.bodies[0].collision = CollisionShape::splinters;
    World world(scene);
    for (int i = 0; i < 30; ++i) world.step();
    hashes.push_back(world.state_hash());
    EXPECT_GT(world.frame().fragments, 0);
  }
  EXPECT_EQ(hashes[0], hashes[1]);
  EXPECT_EQ(hashes[0], hashes[2]);
}

}  // namespace
}  // namespace griffith
