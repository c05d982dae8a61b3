#include <gtest/gtest.h>

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

}  // namespace
}  // namespace griffith
