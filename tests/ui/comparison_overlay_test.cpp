#include <gtest/gtest.h>

#include "ui_driver.h"

namespace griffith::ui {
namespace {

/// The interface with two branches, the second of which is shown.
class ComparisonOverlay : public ::testing::Test {
 protected:
  ComparisonOverlay() : ui_(two_walls()) {
    ui_.input.time.last_step = 20;
    ui_.input.time.branch = 1;
    ui_.input.time.branches = {{-1, 0, 12}, {0, 4, 20}};
    ui_.frame();
  }
  /// As the program does once a branch is chosen.
  void compare() {
    ui_.state.comparison.branch = 0;
    ui_.input.comparison = ComparisonView{0, {}, "Branch 0 differs from step 5 on.", {}};
    ui_.frame();
  }

  UiDriver ui_;
};

TEST_F(ComparisonOverlay, OffersAllOtherBranches) {
  EXPECT_EQ(ui_.value("time/compare"), "off");
  ui_.click("time/compare");
  EXPECT_FALSE(find_tag(ui_.tags, "compare/1")) << "the shown one";
  EXPECT_EQ(ui_.value("compare/none"), "on");
  ui_.click("compare/0");
  EXPECT_EQ(ui_.state.comparison.branch, 0);
  EXPECT_EQ(ui_.value("time/compare"), "with branch 0");
  ui_.click("compare/none");
  EXPECT_FALSE(ui_.state.comparison.branch);
}

TEST_F(ComparisonOverlay, TheBorderIsDraggedAndStaysInTheView) {
  compare();
  EXPECT_EQ(ui_.value("compare/border"), "50 %");
  EXPECT_EQ(ui_.value("compare/difference"), "Branch 0 differs from step 5 on.");
  ui_.drag("compare/border", -0.2F * ui_.state.viewport_size.x);
  EXPECT_NEAR(ui_.state.comparison.border, 0.3F, 0.02F);
  EXPECT_EQ(ui_.state.camera_motion, CameraMotion{}) << "the camera does not turn with it";
  ui_.drag("compare/border", 5000);
  EXPECT_LT(ui_.state.comparison.border, 1);
  EXPECT_GT(ui_.state.comparison.border, 0.9F);
}

TEST_F(ComparisonOverlay, AGhostHasNoBorder) {
  compare();
  ui_.click("time/compare");
  ui_.click("compare/ghost");
  EXPECT_TRUE(ui_.state.comparison.as_ghost);
  EXPECT_FALSE(find_tag(ui_.tags, "compare/border"));
  EXPECT_TRUE(find_tag(ui_.tags, "compare/difference"));
}

TEST_F(ComparisonOverlay, TheTextLiesInTheView) {
  compare();
  const WidgetTag &view = *find_tag(ui_.tags, "viewport"), &text = *find_tag(ui_.tags, "compare/difference");
  EXPECT_GE(text.minimum.x, view.minimum.x);
  EXPECT_LE(text.maximum.x, view.maximum.x);
  EXPECT_LE(text.maximum.y, view.maximum.y);
}

TEST_F(ComparisonOverlay, NamesStayClearOfTheCardThatSaysWhyItStopped) {
  ui_.state.stop = Stop{"Node 12 cracks in the next step, at 161 % of its resistance.", NodeId(12), {}};
  compare();
  const WidgetTag& button = *find_tag(ui_.tags, "time/holding");
  for (const char* name : {"compare/left", "compare/right"}) {
    const WidgetTag* tag = find_tag(ui_.tags, name);
    ASSERT_TRUE(tag) << name;
    EXPECT_GT(tag->minimum.y, button.maximum.y) << name;
  }
}

}  // namespace
}  // namespace griffith::ui
