// Four views in the viewport: their areas, and the mouse in them.

#include "ui/model/four_views.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/random_values.h"
#include "ui_driver.h"

namespace griffith::ui {
namespace {

TEST(FourViewAreas, CoverTheViewportOnce) {
  FourViews views;
  views.shown = true;
  for (const ImVec2 viewport : {ImVec2(800, 600), ImVec2(801, 603), ImVec2(17, 16)}) {
    float area = 0;
    for (int view = 0; view < views.count(); ++view) {
      const ImVec2 size = area_of(views, view, viewport).size;
      EXPECT_EQ(size.x, std::floor(size.x));
      EXPECT_EQ(size.y, std::floor(size.y));
      area += size.x * size.y;
    }
    EXPECT_EQ(area, viewport.x * viewport.y);
    testing::RandomValues random(3);
    for (int trial = 0; trial < 200; ++trial) {
      const Vec2 cursor(random.uniform(0, 1), random.uniform(0, 1));
      const ViewPoint point = view_at(views, cursor, viewport);
      EXPECT_GE(point.place.minCoeff(), 0);
      EXPECT_LT(point.place.maxCoeff(), 1);
      const ViewArea found = area_of(views, point.view, viewport);
      EXPECT_NEAR(found.low.x + point.place.x() * found.size.x, cursor.x() * viewport.x, 1e-3);
      EXPECT_NEAR(found.low.y + point.place.y() * found.size.y, cursor.y() * viewport.y, 1e-3);
    }
  }
}

TEST(FourViewAreas, OneViewIsTheViewport) {
  const Vec2 cursor(0.123, 0.9);
  const ViewPoint point = view_at({}, cursor, {801, 603});
  EXPECT_EQ(point.view, 0);
  EXPECT_EQ(point.place, cursor);
}

TEST(FourViewAreas, SidesAreTheSixAxes) {
  Vec3 sum = Vec3::Zero();
  for (int side = 1; side < static_cast<int>(kViewSideNames.size()); ++side) {
    const Vec3 toward = toward_side(static_cast<ViewSide>(side));
    EXPECT_EQ(toward.cwiseAbs().sum(), 1);
    sum += toward;
  }
  EXPECT_EQ(sum, Vec3::Zero());
}

class FourViewsTest : public ::testing::Test {
 protected:
  FourViewsTest() {
    ui_.press_key('Q', true, false, true);
    EXPECT_THAT(ui_.issued(), ::testing::ElementsAre("view.four"));
    ui_.commands.clear();
    ui_.state.four_views.shown = true;  // the program does it
    ui_.frame();
  }
  /// Returns a point of the viewport, 0..1, on the screen.
  ImVec2 place(float x, float y) const {
    const ImVec2 low = ui_.state.viewport_minimum, size = ui_.state.viewport_size;
    return {low.x + x * size.x, low.y + y * size.y};
  }
  void drag(ImVec2 from, ImVec2 way) {
    ui_.state.camera_motion = {};
    ui_.move(from);
    ui_.press(0, true);
    ui_.move({from.x + way.x, from.y + way.y});
    ui_.press(0, false);
  }

  UiDriver ui_{two_walls()};
};

TEST_F(FourViewsTest, TheViewUnderTheMouseIsActive) {
  const std::pair<ImVec2, int> places[] = {
      {{0.75f, 0.25f}, 0}, {{0.25f, 0.25f}, 1}, {{0.25f, 0.6f}, 2}, {{0.75f, 0.75f}, 3}};
  for (const auto& [at, view] : places) {
    ui_.move(place(at.x, at.y));
    ui_.frame();
    EXPECT_EQ(ui_.state.four_views.active, view);
  }
}

TEST_F(FourViewsTest, DragsRotateTheCameraAndPanTheOthers) {
  drag(place(0.75f, 0.25f), {30, 0});
  EXPECT_NE(ui_.state.camera_motion.yaw, 0);
  EXPECT_EQ(ui_.state.camera_motion.pan_right, 0);
  drag(place(0.25f, 0.25f), {30, 0});
  EXPECT_EQ(ui_.state.camera_motion.yaw, 0);
  EXPECT_NEAR(ui_.state.camera_motion.pan_right, -30 / std::floor(ui_.state.viewport_size.y / 2), 1e-4)
      << "what is under the mouse stays there";
}

TEST_F(FourViewsTest, ADragGoesOnInTheViewInWhichItBegan) {
  ui_.move(place(0.25f, 0.25f));
  ui_.press(0, true);
  ui_.move(place(0.75f, 0.75f));
  EXPECT_EQ(ui_.state.four_views.active, 1);
  ui_.press(0, false);
  ui_.frame();
  EXPECT_EQ(ui_.state.four_views.active, 3);
}

TEST_F(FourViewsTest, ClicksAreGivenInTheViewport) {
  ui_.move(place(0.25f, 0.75f));
  ui_.press(0, true);
  ui_.press(0, false);
  ASSERT_THAT(ui_.issued(), ::testing::ElementsAre("view.pick"));
  EXPECT_NEAR(ui_.commands[0].cursor.x(), 0.25, 0.01);
  EXPECT_NEAR(ui_.commands[0].cursor.y(), 0.75, 0.01);
}

TEST_F(FourViewsTest, NamesOpenSideAndQuantity) {
  EXPECT_EQ(ui_.value("views/3"), "Right");
  ui_.click("views/3");
  ui_.click("views/3/side");
  ui_.click("views/3/side/Left");
  EXPECT_EQ(ui_.state.four_views.sides[3], ViewSide::left);
  EXPECT_EQ(ui_.value("views/3"), "Left");
  ui_.click("views/3/quantity");
  ui_.click("views/3/quantity/speed");
  EXPECT_EQ(ui_.state.four_views.quantities[3], "speed");
  EXPECT_TRUE(ui_.state.four_views.quantities[0].empty());
}

TEST_F(FourViewsTest, HandlesOfTheActiveViewCanBeDragged) {
  ViewCamera top;
  top.eye = Vec3(0, 5, 0);
  top.forward = -Vec3::UnitY();
  top.up = -Vec3::UnitZ();
  ui_.input.views[1].camera = top;
  ui_.state.gizmo = GizmoTool::place;
  ui_.move(place(0.25f, 0.25f));
  ui_.frame();
  ASSERT_TRUE(find_tag(ui_.tags, "gizmo/move_z"));
  EXPECT_FALSE(find_tag(ui_.tags, "gizmo/move_y")) << "along the line of sight";
  ui_.drag("gizmo/move_z", 0, 40);
  const Vec3 moved = ui_.history.scene().bodies[0].position;
  EXPECT_GT(moved.z(), 0.01);
  EXPECT_NEAR(moved.x(), 0, 1e-9);
}

}  // namespace
}  // namespace griffith::ui
