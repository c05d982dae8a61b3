#include <gtest/gtest.h>

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
  for (std::size_t i = 0; i < frame.positions.size(); ++i)
    EXPECT_LT((frame.positions[i] - frame.rest_positions[i] - fallen).norm(), 1e-9);
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

}  // namespace
}  // namespace griffith
