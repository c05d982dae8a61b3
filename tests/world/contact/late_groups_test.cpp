#include <gtest/gtest.h>

#include "sim/scene/scene_reader.h"
#include "sim/world/world.h"

namespace griffith {
namespace {

/// The abutments wake, and grow into a group with a hundred fragments, within the step in which these land on them.
TEST(QuasiStaticBodies, OnesThatWakeInALargeGroupTouchAsRigidOnes) {
  World world(read_scene(GRIFFITH_SOURCE_DIR "/scenes/bridge.json"));
  int iterations = 0, fragments = 0;
  while (world.frame().step < 48) {
    world.step();
    fragments = static_cast<int>(world.frame().bodies.size());
    if (fragments > 100) iterations += world.frame().report.contact_iterations;
  }
  EXPECT_GT(fragments, 100);
  EXPECT_LT(iterations, 50);  // 355 where the abutments are coupled with all of the fragments
}

}  // namespace
}  // namespace griffith
