#include <gtest/gtest.h>

#include <random>
#include <string>

#include "sim/core/temporary_folder.h"
#include "sim/mesh/box_mesh.h"
#include "sim/mesh/write_mesh.h"
#include "sim/world/world.h"
#include "tests/world/scenes.h"

namespace griffith {
namespace {

using testing::brick;
using testing::struck_block;

TEST(Momentum, FreeFallOfABodyIsExact) {
  Scene scene = struck_block(brick(1));
  scene.gravity = Vec3(0, -9.81, 0);
  scene.projectiles.clear();
  scene.bodies[0].velocity = Vec3(1, 2, 3);
  scene.bodies[0].rotation_degrees = Vec3(20, 30, 40);
  World world(scene);
  const int steps = 120;
  for (int i = 0; i < steps; ++i) world.step();
  const Frame frame = world.frame();
  const double h = scene.simulation.time_step, t = steps * h;
  const Vec3 fallen = scene.bodies[0].velocity * t + 0.5 * scene.gravity * t * (t + h);
  for (std::size_t i = 0; i < frame.nodes.positions.size(); ++i)
    EXPECT_LT((frame.nodes.positions[i] - frame.nodes.rest_positions[i] - fallen).norm(), 1e-9);
  EXPECT_EQ(frame.crack_events.size(), 0u);
}

TEST(Momentum, ASpinningBodyKeepsItsAngularMomentum) {
  Scene scene = struck_block(brick(1));
  scene.projectiles.clear();
  scene.bodies[0].angular_velocity = Vec3(0.3, 2, -1);
  World world(scene);
  const Vec3 before = world.frame().totals.angular_momentum;
  for (int i = 0; i < 240; ++i) world.step();
  EXPECT_LT((world.frame().totals.angular_momentum - before).norm(), 1e-6 * before.norm());
  EXPECT_EQ(world.frame().bodies.size(), 1u);
}

TEST(Momentum, PiecesOfOneMeshSpinAboutTheirCommonCenter) {
  const griffith::TemporaryFolder folder;
  TetSoup soup = make_box(Vec3(1, 1, 1), Vec3::Constant(0.5), BoxPattern::five_tet);
  const TetSoup small = make_box(Vec3(0.5, 0.5, 0.5), Vec3::Constant(0.5), BoxPattern::five_tet);
  const int first = static_cast<int>(soup.points.size());
  for (const Vec3& point : small.points) soup.points.push_back(point + Vec3(3, 1, 0));
  for (std::array<int, 4> tet : small.tets) {
    for (int& corner : tet) corner += first;
    soup.tets.push_back(tet);
  }
  write_gmsh(folder.path() / "two.msh", soup);
  Scene scene = struck_block(brick(1));
  scene.projectiles.clear();
  scene.bodies[0].shape = MeshFileShape{.path = folder.path() / "two.msh"};
  scene.bodies[0].velocity = Vec3(1, 0, 0);
  scene.bodies[0].angular_velocity = Vec3(0.3, 2, -1);
  const World world(scene);
  const Frame frame = world.frame();
  ASSERT_EQ(frame.bodies.size(), 2u);
  const Vec3 center = (8 * Vec3::Zero() + 1 * Vec3(3, 1, 0)) / 9;
  for (std::size_t i = 0; i < frame.nodes.positions.size(); ++i) {
    const Vec3 expected = Vec3(1, 0, 0) + Vec3(0.3, 2, -1).cross(frame.nodes.positions[i] - center);
    EXPECT_LT((frame.nodes.velocities[i] - expected).norm(), 1e-12);
  }
}

/// Two boxes of other sizes that meet off their centers, in weightless space.
Scene meeting_boxes(std::mt19937& random, double time_step) {
  std::uniform_real_distribution<double> number(-1, 1);
  const auto vector = [&](double scale) { return Vec3(scale * Vec3(number(random), number(random), number(random))); };
  Scene scene;
  scene.gravity.setZero();
  scene.ground.reset();
  scene.simulation.time_step = time_step;
  scene.simulation.fracture = false;
  for (int i = 0; i < 2; ++i) {
    BodyDescription& body = scene.bodies.emplace_back();
    body.name = "box " + std::to_string(i);
    body.shape = BoxShape{Vec3(0.3, 0.4, 0.5) + vector(0.2), Vec3::Constant(1), BoxPattern::five_tet};
    body.position = Vec3(i == 0 ? -0.8 : 0.8, 0, 0) + vector(0.15);
    body.velocity = Vec3(i == 0 ? 2 : -1, 0, 0) + vector(0.3);
    body.rotation_degrees = vector(180);
    body.angular_velocity = vector(2);
  }
  return scene;
}

/// Contacts act within a step, where both bodies have come to: at two places they would change angular momentum.
TEST(Momentum, BodiesThatCollideWithinLongStepsKeepIt) {
  std::mt19937 random(11);
  int collided = 0;
  for (int i = 0; i < 24; ++i) {
    World world(meeting_boxes(random, i % 2 == 0 ? 1.0 / 30 : 1.0 / 60));
    const Vec3 linear = world.frame().totals.momentum, angular = world.frame().totals.angular_momentum;
    const double exchanged = 2 * world.frame().bodies[0].mass * world.frame().bodies[0].velocity.norm();
    bool touched = false;
    while (world.frame().time < 0.8) {
      world.step();
      touched |= !world.frame().contacts.empty();
    }
    collided += touched;
    EXPECT_LT((world.frame().totals.momentum - linear).norm(), 1e-9 * exchanged) << i;
    EXPECT_LT((world.frame().totals.angular_momentum - angular).norm(), 5e-3 * 0.5 * exchanged) << i;
  }
  EXPECT_GT(collided, 12);
}

}  // namespace
}  // namespace griffith
