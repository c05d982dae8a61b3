#include "ui/model/gizmo.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <functional>

#include "ui_driver.h"

namespace griffith::ui {
namespace {

ViewCamera oblique_camera() {
  ViewCamera camera;
  camera.eye = Vec3(3, 2, 4);
  camera.forward = -camera.eye.normalized();
  camera.right = camera.forward.cross(Vec3::UnitY()).normalized();
  camera.up = camera.right.cross(camera.forward);
  return camera;
}

/// The panels with the gizmo of the first body.
class GizmoTest : public ::testing::Test {
 protected:
  GizmoTest() {
    ui_.input.views[0].camera = oblique_camera();
    ui_.input.high = Vec3(2, 2, 2);
    ui_.state.gizmo = GizmoTool::place;
    ui_.frame();
  }
  const BodyDescription& body() const { return ui_.history.scene().bodies[0]; }
  bool at_start() const { return ui_.history.scene() == two_walls(); }
  bool shown() const { return find_tag(ui_.tags, "gizmo/turn_y") != nullptr; }
  /// Presses the button over it and moves a little.
  void begin(const std::string& tag) {
    ui_.move(ui_.find(tag));
    ui_.press(0, true);
    const ImVec2 mouse = ImGui::GetIO().MousePos;
    ui_.move({mouse.x + 40, mouse.y + 30});
  }

  UiDriver ui_{two_walls()};
};

TEST_F(GizmoTest, AKeyShowsIt) {
  ui_.press_key('G');
  ASSERT_EQ(ui_.issued(), std::vector<std::string_view>{"edit.gizmo"});
  ui_.state.gizmo = GizmoTool::none;
  ui_.frame();
  EXPECT_FALSE(shown());
}

TEST_F(GizmoTest, StandsWhereAnEditWouldTakeEffect) {
  EXPECT_TRUE(shown());
  ui_.input.frame.step = 1;
  ui_.frame();
  EXPECT_FALSE(shown());
}

TEST_F(GizmoTest, ArrowsAndPlanesMoveAlongTheirAxesAlone) {
  const std::pair<const char*, std::array<bool, 3>> handles[] = {
      {"gizmo/move_x", {true, false, false}}, {"gizmo/move_y", {false, true, false}},
      {"gizmo/move_z", {false, false, true}}, {"gizmo/move_xy", {true, true, false}},
      {"gizmo/move_yz", {false, true, true}}, {"gizmo/move_xz", {true, false, true}}};
  for (const auto& [tag, axes] : handles) {
    const Vec3 before = body().position;
    const std::size_t entries = ui_.history.entries().size();
    ui_.drag(tag, 37, -61);
    for (std::size_t axis = 0; axis < 3; ++axis)
      EXPECT_EQ(body().position[static_cast<int>(axis)] != before[static_cast<int>(axis)], axes[axis]) << tag << axis;
    EXPECT_EQ(ui_.history.entries().size(), entries + 1) << tag << ": one entry a drag";
    EXPECT_EQ(body().rotation_degrees, Vec3::Zero());
  }
}

TEST_F(GizmoTest, WhatIsDraggedStaysUnderTheCursor) {
  for (const char* tag : {"gizmo/move_xy", "gizmo/move_yz", "gizmo/move_xz"}) {
    const ImVec2 before = ui_.find(tag);
    ui_.move(before);
    ui_.press(0, true);
    ui_.move({before.x + 60, before.y - 25});
    const ImVec2 after = ui_.find(tag);
    ui_.press(0, false);
    // The gizmo keeps its size on the screen, so its grip follows but for perspective.
    EXPECT_NEAR(after.x, before.x + 60, 6) << tag;
    EXPECT_NEAR(after.y, before.y - 25, 6) << tag;
  }
}

TEST_F(GizmoTest, RingsTurn) {
  for (int axis = 0; axis < 3; ++axis) {
    const std::string tag = std::string("gizmo/turn_") + "xyz"[axis];
    const Vec3 before = body().rotation_degrees;
    ui_.drag(tag, 30, 20);
    EXPECT_NE(body().rotation_degrees, before) << tag;
    EXPECT_EQ(body().position, Vec3::Zero()) << tag;
  }
  EXPECT_EQ(ui_.history.entries().size(), 3u);
}

TEST_F(GizmoTest, UndoAndRedoGiveTheSameScenes) {
  ui_.drag("gizmo/move_x", 50);
  const Scene moved = ui_.history.scene();
  EXPECT_EQ(ui_.history.entries().back().label, "Move left");
  ui_.history.undo();
  EXPECT_TRUE(at_start());
  ui_.history.redo();
  EXPECT_EQ(ui_.history.scene(), moved);
}

TEST_F(GizmoTest, EscapeLeavesTheBodyWhereItWas) {
  ui_.drag("gizmo/move_y", 0, -40);
  ui_.history.undo();
  begin("gizmo/move_x");
  EXPECT_NE(ui_.state.gizmo_drag->placement, ui_.state.gizmo_drag->start);
  ui_.press_key(key::kEscape);
  ui_.move({700, 500});
  ui_.press(0, false);
  EXPECT_TRUE(at_start());
  EXPECT_TRUE(ui_.history.can_redo()) << "nothing was done";
  EXPECT_FALSE(ui_.state.gizmo_drag);
}

TEST_F(GizmoTest, ADragEndsWhereTheSceneChangesUnderIt) {
  const std::vector<std::function<void()>> disturbances = {
      [this] { ui_.history.change("rename", [](Scene& scene) { scene.bodies[0].name = "wall"; }); },
      [this] { ui_.history.change("delete", [](Scene& scene) { scene.bodies.clear(); }); },
      [this] { ui_.input.frame.step = 5; }};
  for (const auto& disturb : disturbances) {
    begin("gizmo/move_x");
    disturb();
    ui_.frame();
    ui_.press(0, false);
    ui_.history.finish();
    for (const BodyDescription& left : ui_.history.scene().bodies) EXPECT_EQ(left.position, Vec3::Zero());
    ui_.history.undo();
    ui_.input.frame.step = 0;
    ui_.frame();
  }
}

TEST_F(GizmoTest, ControlTakesRoundSteps) {
  ui_.queue.key(key::kLeftControl, true);
  ui_.drag("gizmo/move_x", 51);
  ui_.drag("gizmo/turn_y", 33);
  ui_.queue.key(key::kLeftControl, false);
  constexpr double kStep = 0.05;  // bodies are 3.5 m across
  const double steps = body().position.x() / kStep, turns = body().rotation_degrees.y() / 15;
  EXPECT_NEAR(steps, std::round(steps), 1e-9);
  EXPECT_NEAR(turns, std::round(turns), 1e-9);
  EXPECT_NE(std::round(steps), 0);
  EXPECT_NE(std::round(turns), 0);
}

TEST_F(GizmoTest, ReportsItsPosition) {
  begin("gizmo/move_x");
  EXPECT_EQ(ui_.value("gizmo/move_x").substr(0, 2), "x ");
  ui_.press(0, false);
  begin("gizmo/turn_y");
  EXPECT_EQ(ui_.value("gizmo/turn_y").substr(0, 8), "about y ");
}

TEST_F(GizmoTest, AClickOnItChangesNothing) {
  ui_.click("gizmo/move_x");
  ui_.click("gizmo/turn_y");
  EXPECT_TRUE(at_start());
  EXPECT_TRUE(ui_.history.entries().empty());
  EXPECT_TRUE(ui_.commands.empty()) << "no node is picked through it";
}

TEST_F(GizmoTest, BesideItTheMouseTurnsTheCamera) {
  ui_.move({400, 250});
  ui_.press(0, true);
  ui_.move({430, 250});
  EXPECT_NE(ui_.state.camera_motion.yaw, 0);
  EXPECT_FALSE(ui_.state.gizmo_drag);
  ui_.press(0, false);
}

TEST_F(GizmoTest, APlaceBeyondTheLimitsOfTheSceneIsNotReached) {
  ui_.history.change("far", [](Scene& scene) { scene.bodies[0].position = Vec3(9.9e5, 0, 0); });
  ui_.history.finish();
  ui_.input.views[0].camera.eye = Vec3(9.9e5, 0, 0) + 1e6 * oblique_camera().eye;
  ui_.frame();
  ui_.drag("gizmo/move_x", 400, 200);
  EXPECT_LE(body().position.x(), 1e6);
}

TEST(Gizmo, KeepsItsSizeOnTheScreen) {
  ViewCamera near = oblique_camera(), far = near;
  far.eye *= 10;
  const auto width = [](const ViewCamera& camera) {
    const std::vector<HandleShape> shapes = handle_shapes(camera, Vec3::Zero(), 100);
    return (shapes[0].outline.back() - shapes[0].outline.front()).norm();
  };
  EXPECT_NEAR(width(near) / width(far), 1, 0.1);
}

TEST(Gizmo, HidesWhatCannotBeDraggedAsItIsSeen) {
  const std::vector<HandleShape> shapes = handle_shapes(ViewCamera{}, Vec3::Zero(), 100);  // looks along z
  std::vector<std::string> names;
  for (const HandleShape& shape : shapes) names.push_back(handle_name(shape.handle));
  EXPECT_EQ(names, (std::vector<std::string>{"move_x", "move_y", "move_xy", "turn_x", "turn_y", "turn_z", "move"}));
  EXPECT_TRUE(handle_shapes(ViewCamera{}, Vec3(0, 0, 9), 100).empty()) << "behind the eye";
}

}  // namespace
}  // namespace griffith::ui
