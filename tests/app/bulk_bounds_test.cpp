#include "app/picture/bulk_bounds.h"

#include <gtest/gtest.h>

#include "program.h"
#include "sim/world/world.h"

namespace griffith::app {
namespace {

BodyDescription cube(const std::string& name, double edge, const Vec3& position) {
  BodyDescription body;
  body.name = name;
  body.shape = BoxShape{Vec3::Constant(edge), Vec3::Constant(edge), BoxPattern::five_tet};
  body.position = position;
  return body;
}

Eigen::AlignedBox3f bounds_in(const Scene& scene, int steps = 0) {
  World world(scene);
  for (int step = 0; step < steps; ++step) world.step();
  const Frame frame = world.frame();
  return bulk_bounds(shown_mesh(frame, scene.view, {}));
}

TEST(BulkBounds, LeavesOutTheShardThatFlewFarAndNotTheOneNearby) {
  for (const double distance : {0.8, 60.0}) {
    Scene scene;
    scene.bodies = {cube("rest", 1, Vec3(0, 0.5, 0)), cube("shard", 0.1, Vec3(distance, 0.05, 0))};
    const Eigen::AlignedBox3f box = bounds_in(scene);
    EXPECT_TRUE(box.contains(Eigen::AlignedBox3f(Eigen::Vector3f(-0.5f, 0, -0.5f), Eigen::Vector3f(0.5f, 1, 0.5f))));
    EXPECT_NEAR(box.max().x(), distance < 1 ? distance + 0.05 : 0.5, 1e-5);
  }
}

TEST(BulkBounds, HoldsEveryOneOfManyAlike) {
  Scene scene;
  for (int i = 0; i < 40; ++i) scene.bodies.push_back(cube("body " + std::to_string(i), 0.5, Vec3(2.0 * i, 0.25, 0)));
  const Eigen::AlignedBox3f box = bounds_in(scene);
  EXPECT_NEAR(box.min().x(), -0.25, 1e-5);
  EXPECT_NEAR(box.max().x(), 78.25, 1e-5);
}

TEST(BulkBounds, HoldsAProjectileAtTheBodiesAndNotOneFarAway) {
  for (const double distance : {1.0, 40.0}) {
    Scene scene;
    scene.bodies = {cube("target", 1, Vec3(0, 0.5, 0))};
    ProjectileBurst shot;
    shot.position = Vec3(0, 0.5, distance);
    shot.radius = 0.1;
    shot.speed = 1;
    scene.projectiles = {shot};
    EXPECT_EQ(bounds_in(scene, 1).max().z() > 0.6f, distance == 1) << distance;
  }
}

TEST(BulkBounds, AreEmptyWithoutBodies) {
  const Frame frame;
  const ViewSettings view;
  EXPECT_TRUE(bulk_bounds(shown_mesh(frame, view, {})).isEmpty());
}

}  // namespace
}  // namespace griffith::app
