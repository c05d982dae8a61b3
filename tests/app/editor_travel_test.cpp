// Long ways back into the recorded past.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "editor_fixture.h"

namespace griffith::app {
namespace {

using ::testing::HasSubstr;

/// A wall whose steps take some milliseconds, in an editor with memory for hardly any copy of it.
class FarTravelTest : public EditorTest {
 protected:
  static Scene slow_wall() {
    Scene scene = small_wall();
    std::get<BoxShape>(scene.bodies[0].shape).element_size = Vec3::Constant(1.0 / 9);
    scene.bodies[0].remeshing = true;  // without shards, which take as long as the steps
    scene.projectiles.clear();
    Load later;  // keeps it awake: a sleeper would be back at once
    later.region = HalfSpaceRegion{Vec3::Zero(), Vec3::UnitY()};
    later.start = 1e6;
    scene.bodies[0].loads = {later};
    return scene;
  }
  FarTravelTest() : EditorTest(slow_wall()) {
    editor_.state().preferences.past_memory = 1;
    draw();
  }
};

TEST_F(FarTravelTest, GoingBackFarShowsProgressAndCanBeCancelled) {
  constexpr int kSteps = 250;
  std::uint64_t hash = 0;
  for (int i = 0; i < kSteps; ++i) {
    editor_.run().step();
    if (i == kSteps - 2) hash = editor_.run().timeline().world().state_hash();
  }
  ASSERT_GE(editor_.run().timeline().interval(), 256) << "no copy but the first";
  editor_.execute({.name = "time.back"});
  ASSERT_THAT(editor_.state().work, HasSubstr("going to step 249"));
  draw(3);
  EXPECT_THAT(value("work/stage"), HasSubstr("Repeating"));
  wait_for_work();
  EXPECT_EQ(editor_.run().frame().step, kSteps - 1);
  EXPECT_EQ(editor_.run().timeline().world().state_hash(), hash);
  editor_.execute({.name = "time.back"});
  draw(4);
  click("work/cancel");
  draw(3);
  EXPECT_TRUE(editor_.state().work.empty());
  EXPECT_LT(editor_.run().frame().step, kSteps - 2) << "where it had got to";
  EXPECT_EQ(editor_.run().timeline().last_step(), kSteps);
}

}  // namespace
}  // namespace griffith::app
