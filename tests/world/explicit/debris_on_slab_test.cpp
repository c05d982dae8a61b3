#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "sim/world/world.h"
#include "tests/world/contact/contact_scenes.h"

namespace griffith {
namespace {

/// A block of ice that falls on a slab of granite, whose foot is held. The top of the slab is at height 0.
Scene block_on_slab(double time_step) {
  Scene scene;
  scene.ground.reset();
  scene.simulation.time_step = time_step;
  BodyDescription slab =
      testing::box("slab", Vec3(2, 0.1, 2), Vec3(0, -0.05, 0), testing::preset("granite"), Vec3(0.5, 0.1, 0.5));
  slab.supports = {{HalfSpaceRegion{Vec3::Zero(), -Vec3::UnitY()}}};
  BodyDescription block =
      testing::box("block", Vec3(0.1, 0.08, 0.07), Vec3(0, 0.12, 0), testing::preset("ice"), Vec3::Constant(0.05));
  block.rotation_degrees = Vec3(20, 10, 35);
  block.velocity = Vec3(0, -3, 0);
  scene.bodies = {slab, block};
  return scene;
}

/// Returns that of the pieces of the block that have not flown beyond the slab [m].
double lowest_center(const Frame& frame) {
  double lowest = std::numeric_limits<double>::infinity();
  for (const BodyView& body : frame.bodies) {
    const Vec3& center = body.center_of_mass;
    if (body.scene_body == 1 && std::max(std::abs(center.x()), std::abs(center.z())) < 0.95)
      lowest = std::min(lowest, center.y());
  }
  return lowest;
}

/// Some chips are rigid while others, and the slab, are in microsteps: they must not sink into it.
TEST(DebrisOnSlab, LiesOnItWhileOtherPiecesOfTheSameBodyAreInMicrosteps) {
  constexpr double kHalfAChip = 5e-3;  // [m]
  for (const double time_step : {1.0 / 30, 1.0 / 60}) {
    World world(block_on_slab(time_step));
    while (world.frame().time < 0.8) {
      world.step();
      ASSERT_GT(lowest_center(world.frame()), kHalfAChip) << world.frame().time << ", " << time_step;
    }
    EXPECT_GE(world.frame().bodies.size(), 5U);
  }
}

}  // namespace
}  // namespace griffith
