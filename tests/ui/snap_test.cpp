// Snapping to surfaces: what is put down touches and overlaps nothing.

#include "ui/model/snap.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

#include "app/editor/placed_surface.h"
#include "sim/scene/body_pose.h"
#include "sim/world/world.h"
#include "ui_driver.h"

namespace griffith::ui {
namespace {

constexpr double kTouching = 1e-5;  ///< [m]; sides are narrowed by a millionth for comparison

BodyDescription box(const std::string& name, const Vec3& size, const Vec3& position,
                    const Vec3& degrees = Vec3::Zero()) {
  BodyDescription body;
  body.name = name;
  body.shape = BoxShape{size, size / 2, BoxPattern::five_tet};
  body.position = position;
  body.rotation_degrees = degrees;
  return body;
}

SnapScene surfaces_of(const Scene& scene, const SceneEntry& entry = {}) {
  const World world(scene);
  return snap_scene(scene, world.frame(), entry, {});
}

ViewRay ray_to(const Vec3& eye, const Vec3& point) { return {eye, (point - eye).normalized()}; }

/// Returns the gap along a direction between the first body, moved, and another.
double gap_after(const Scene& scene, const Vec3& offset, std::size_t other, const Vec3& direction) {
  PlacedSurface moved = app::placed_surface(scene.bodies[0], {});
  move_surface(moved, offset);
  return gap_along(direction, moved, app::placed_surface(scene.bodies[other], {})).value_or(1e9);
}

TEST(SnapToRay, ABodyOfAnyRotationIsPutOntoTheGround) {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> angle(-180, 180);
  for (int i = 0; i < 20; ++i) {
    Scene scene;
    scene.bodies = {box("box", Vec3(0.4, 0.2, 0.3), Vec3(0, 3, 0), Vec3(angle(random), angle(random), angle(random)))};
    const std::optional<Snap> snap =
        snap_to_ray(surfaces_of(scene), scene.bodies[0].position, ray_to(Vec3(0, 4, 6), Vec3(1, 0, -0.5)));
    ASSERT_TRUE(snap);
    EXPECT_EQ(snap->onto, "the ground");
    scene.bodies[0].position += snap->offset;
    const Eigen::AlignedBox3d placed = app::placed_box(scene.bodies[0], {});
    EXPECT_NEAR(placed.min().y(), 0, 1e-9);
    EXPECT_NEAR(placed.center().x(), 1, 1e-9);
    EXPECT_NEAR(placed.center().z(), -0.5, 1e-9);
  }
}

TEST(SnapToRay, ABodyTouchesTheFaceOfAnother) {
  Scene scene;
  scene.bodies = {box("moved", Vec3(0.2, 0.2, 0.2), Vec3(5, 3, 0), Vec3(20, 30, 40)),
                  box("block", Vec3(1, 1, 1), Vec3(0, 0.5, 0))};
  const std::pair<Vec3, Vec3> points[] = {
      {Vec3(0.1, 1, 0.2), Vec3::UnitY()}, {Vec3(0.2, 0.6, 0.5), Vec3::UnitZ()}, {Vec3(0.5, 0.6, 0.1), Vec3::UnitX()}};
  for (const auto& [point, normal] : points) {
    const std::optional<Snap> snap =
        snap_to_ray(surfaces_of(scene), scene.bodies[0].position, ray_to(Vec3(4, 5, 6), point));
    ASSERT_TRUE(snap);
    EXPECT_EQ(snap->onto, "block");
    EXPECT_LT((snap->normal - normal).norm(), 1e-9);
    EXPECT_NEAR(gap_after(scene, snap->offset, 1, normal), 0, kTouching);
  }
}

TEST(SnapToRay, NothingSinksIntoWhatStandsNextToThePoint) {
  Scene scene;
  scene.bodies = {box("moved", Vec3(1, 0.2, 1), Vec3(5, 3, 0)), box("slab", Vec3(4, 0.2, 4), Vec3(0, 0.1, 0)),
                  box("low", Vec3(0.1, 0.05, 0.1), Vec3(0.3, 0.225, 0.3))};
  const std::optional<Snap> snap =
      snap_to_ray(surfaces_of(scene), scene.bodies[0].position, ray_to(Vec3(0, 5, 6), Vec3(0, 0.2, 0)));
  ASSERT_TRUE(snap);
  EXPECT_EQ(snap->onto, "slab");
  EXPECT_NEAR(gap_after(scene, snap->offset, 2, Vec3::UnitY()), 0, kTouching) << "it lies on the small one";
  EXPECT_GT(gap_after(scene, snap->offset, 1, Vec3::UnitY()), 0.04);
}

TEST(SnapToRay, AtTheFootOfAWallABodyStaysAboveTheGround) {
  Scene scene;
  scene.bodies = {box("moved", Vec3(0.4, 0.6, 0.4), Vec3(5, 3, 0)), box("wall", Vec3(3, 2, 0.2), Vec3(0, 1, 0))};
  const std::optional<Snap> snap =
      snap_to_ray(surfaces_of(scene), scene.bodies[0].position, ray_to(Vec3(0, 1, 6), Vec3(0.2, 0.05, 0.1)));
  ASSERT_TRUE(snap);
  scene.bodies[0].position += snap->offset;
  EXPECT_NEAR(app::placed_box(scene.bodies[0], {}).min().y(), 0, 1e-9);
  EXPECT_NEAR(app::placed_box(scene.bodies[0], {}).min().z(), 0.1, 1e-9);
}

TEST(SnapToRay, ABodyMovesAsideForItsNeighbors) {
  std::mt19937 random(11);
  std::uniform_real_distribution<double> place(-0.9, 0.9), angle(-180, 180);
  for (int i = 0; i < 20; ++i) {
    Scene scene;
    scene.bodies = {box("moved", Vec3(0.4, 0.3, 0.5), Vec3(9, 3, 0), Vec3(0, angle(random), 0)),
                    box("neighbor", Vec3(0.6, 0.5, 0.4), Vec3(0, 0.25, 0), Vec3(0, angle(random), 0))};
    const std::optional<Snap> snap = snap_to_ray(surfaces_of(scene), scene.bodies[0].position,
                                                 ray_to(Vec3(0, 5, 6), Vec3(place(random), 0, place(random))));
    ASSERT_TRUE(snap);
    const Vec3 up = Vec3::UnitY();
    const double above = gap_after(scene, snap->offset, 1, up);
    const Vec3 apart = scene.bodies[0].position + snap->offset - scene.bodies[1].position;
    double separation = above;
    for (int turn = 0; turn < 36; ++turn) {  // upright bodies are apart if they are in some horizontal direction
      const Vec3 direction(std::cos(turn * std::numbers::pi / 18), 0, std::sin(turn * std::numbers::pi / 18));
      if (direction.dot(apart) > 0) separation = std::max(separation, gap_after(scene, snap->offset, 1, direction));
    }
    EXPECT_GT(separation, -0.01) << "up to the 10 degrees between directions";
    scene.bodies[0].position += snap->offset;
    EXPECT_GE(app::placed_box(scene.bodies[0], {}).min().y(), -1e-9);
  }
}

TEST(SnapToRay, ABallIsPutDownAtItsRadius) {
  Scene scene;
  scene.projectiles = {{}};
  const SnapScene surfaces = surfaces_of(scene, {EntryKind::projectile, 0});
  const std::optional<Snap> snap =
      snap_to_ray(surfaces, scene.projectiles[0].position, ray_to(Vec3(0, 5, 6), Vec3(1, 0, 0)));
  ASSERT_TRUE(snap);
  EXPECT_LT((scene.projectiles[0].position + snap->offset - Vec3(1, scene.projectiles[0].radius, 0)).norm(), 1e-9);
}

TEST(SnapToRay, ARayIntoTheSkyHitsNothing) {
  Scene scene;
  scene.bodies = {box("moved", Vec3::Ones(), Vec3(0, 0.5, 0))};
  EXPECT_FALSE(snap_to_ray(surfaces_of(scene), Vec3::Zero(), ray_to(Vec3(0, 1, 6), Vec3(0, 3, 0))));
}

TEST(SnapAlong, FacesTouchWithinReachAlone) {
  Scene scene;
  scene.bodies = {box("moved", Vec3::Ones(), Vec3(0, 0.5, 0)), box("next", Vec3(1, 1, 1), Vec3(2, 0.6, 0.3))};
  const SnapScene surfaces = surfaces_of(scene);
  for (const double x : {0.97, 1.02, 2.98, 3.04}) {  // on either side, apart and overlapping
    const std::optional<Snap> snap = snap_along(surfaces, Vec3(x, 0, 0), 0, 0.05);
    ASSERT_TRUE(snap) << x;
    EXPECT_EQ(snap->onto, "next");
    EXPECT_NEAR(snap->offset.x(), x < 2 ? 1 : 3, kTouching);
    EXPECT_EQ(snap->offset.y(), 0);
  }
  EXPECT_FALSE(snap_along(surfaces, Vec3(0.9, 0, 0), 0, 0.05));
  EXPECT_FALSE(snap_along(surfaces, Vec3(0.97, 0, 5), 0, 0.05)) << "they pass each other";
  const std::optional<Snap> ground = snap_along(surfaces, Vec3(0, 0.03, 5), 1, 0.05);
  ASSERT_TRUE(ground);
  EXPECT_NEAR(ground->offset.y(), 0, 1e-12);
}

/// The panels with a box that floats next to another, and the frame of their world.
class SnapTest : public ::testing::Test {
 protected:
  static Scene scene() {
    Scene scene;
    scene.bodies = {box("moved", Vec3(0.4, 0.4, 0.4), Vec3(-1, 0.5, 0)),
                    box("block", Vec3(0.6, 0.6, 0.6), Vec3(0.5, 0.3, 0))};
    return scene;
  }
  SnapTest() {
    ui_.input.frame = world_.frame();
    ViewCamera& camera = ui_.input.views[0].camera;
    camera.eye = Vec3(0, 3, 4);
    camera.forward = -camera.eye.normalized();
    camera.right = camera.forward.cross(Vec3::UnitY()).normalized();
    camera.up = camera.right.cross(camera.forward);
    ui_.input.high = Vec3(2, 2, 2);
    ui_.state.gizmo = GizmoTool::place;
    ui_.state.snap = true;
    ui_.state.snap_target = SnapTarget::surfaces;
    ui_.frame();
  }
  const BodyDescription& moved() const { return ui_.history.scene().bodies[0]; }
  ImVec2 pixel_at(const Vec3& point) const {
    ViewCamera camera = ui_.input.views[0].camera;
    camera.width = ui_.state.viewport_size.x;
    camera.height = ui_.state.viewport_size.y;
    const Vec2 pixel = *camera.pixel(point);
    return {ui_.state.viewport_minimum.x + static_cast<float>(pixel.x()),
            ui_.state.viewport_minimum.y + static_cast<float>(pixel.y())};
  }
  void drag_middle_to(const Vec3& point) {
    const ImVec2 grip = ui_.find("gizmo/move"), end = pixel_at(point);
    ui_.drag("gizmo/move", end.x - grip.x, end.y - grip.y);
  }

  World world_{scene()};
  UiDriver ui_{scene()};
};

TEST_F(SnapTest, TheMiddlePutsTheBodyOntoTheOneBelowTheMouse) {
  drag_middle_to(Vec3(0.5, 0.6, 0.1));
  EXPECT_NEAR(moved().position.y(), 0.8, 1e-6);
  EXPECT_NEAR(moved().position.x(), 0.5, 0.02);
  EXPECT_EQ(ui_.history.entries().size(), 1u);
}

TEST_F(SnapTest, ControlMovesItFreely) {
  ui_.queue.key(key::kLeftControl, true);
  drag_middle_to(Vec3(0.5, 0.6, 0.1));
  ui_.queue.key(key::kLeftControl, false);
  EXPECT_GT(std::abs(moved().position.y() - 0.8), 1e-3) << "it stays in a plane parallel to the picture";
}

TEST_F(SnapTest, AnArrowStopsWhereBodiesTouch) {
  ui_.history.change("lower", [](Scene& scene) { scene.bodies[0].position.y() = 0.2; });
  ui_.history.finish();
  Scene lowered = scene();
  lowered.bodies[0].position.y() = 0.2;
  world_ = World(lowered);
  ui_.input.frame = world_.frame();
  ui_.frame();
  const ImVec2 from = pixel_at(Vec3(-1, 0.2, 0)), to = pixel_at(Vec3(-0.02, 0.2, 0));
  ui_.drag("gizmo/move_x", to.x - from.x, to.y - from.y);
  EXPECT_NEAR(moved().position.x(), 0, 1e-6);
  EXPECT_EQ(moved().position.y(), 0.2);
}

TEST_F(SnapTest, NamesWhatItTouches) {
  ui_.move(ui_.find("gizmo/move"));
  ui_.press(0, true);
  ui_.move(pixel_at(Vec3(0.5, 0.6, 0.1)));
  EXPECT_NE(ui_.value("gizmo/move").find("touches block"), std::string::npos) << ui_.value("gizmo/move");
  ui_.move(pixel_at(Vec3(-0.6, 0, 1)));
  EXPECT_NE(ui_.value("gizmo/move").find("touches the ground"), std::string::npos) << ui_.value("gizmo/move");
  ui_.press(0, false);
}

TEST_F(SnapTest, ThePanelSetsIt) {
  ui_.click("handles/snap");
  ui_.press_key(key::kTab, false, true);
  EXPECT_EQ(ui_.issued(), (std::vector<std::string_view>{"edit.snap", "edit.snap"}));
}

}  // namespace
}  // namespace griffith::ui
