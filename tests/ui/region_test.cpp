// Regions of supports, loads and probes: outlines, what can be dragged, and places of entries.

#include <gtest/gtest.h>

#include <numbers>

#include "sim/scene/body_pose.h"
#include "sim/scene/scene_reader.h"
#include "sim/scene/scene_writer.h"
#include "tests/random_values.h"
#include "ui/model/entry_place.h"
#include "ui/model/region_outline.h"
#include "ui_driver.h"

namespace griffith::ui {
namespace {

const BoxRegion kBox{Vec3(-0.5, -0.5, -0.5), Vec3(0.5, -0.2, 0.5)};
const SphereRegion kSphere{Vec3(0.1, 0.2, 0.3), 0.4};
const HalfSpaceRegion kHalfSpace{Vec3(0, -0.4, 0), Vec3(0, -3, 1)};

/// A turned body with a support, a load and two probes, a shot and a camera.
Scene placed_scene() {
  Scene scene = two_walls();
  scene.bodies[1].position = Vec3(1, 2, 3);
  scene.bodies[1].rotation_degrees = Vec3(20, 40, -60);
  scene.bodies[1].supports = {{kBox}};
  scene.bodies[1].loads.resize(1);
  scene.bodies[1].loads[0].region = kSphere;
  scene.probes = {probe_of("right", "point"), probe_of("right", "plane")};
  scene.probes[1].at = Region(kHalfSpace);
  scene.projectiles.resize(1);
  scene.cameras.resize(1);
  return scene;
}

TEST(RegionLines, LieOnTheBoundary) {
  for (const Region& region : {Region(kBox), Region(kSphere), Region(kHalfSpace)}) {
    const std::vector<RegionLine> lines = region_lines(region, 1);
    ASSERT_GT(lines.size(), 4u);
    for (const auto& [a, b] : lines) {
      EXPECT_TRUE(contains(region, a, 0, 1e-12));
      EXPECT_TRUE(contains(region, b, 0, 1e-12));
    }
  }
  EXPECT_EQ(region_lines(kBox, 1).size(), 12u);
  EXPECT_TRUE(region_lines(NodeListRegion{{1, 2}}, 1).empty());
}

TEST(RegionGrips, MoveTheirFaceAndNoOther) {
  for (std::size_t grip = 0; grip < 6; ++grip) {
    const RegionGrip before = region_grips(kBox)[grip];
    const Region dragged = drag_grip(kBox, grip, 0.125, 0);
    const std::vector<RegionGrip> grips = region_grips(dragged);
    EXPECT_DOUBLE_EQ((grips[grip].place - before.place).dot(before.direction), 0.125);
    const std::size_t opposite = grip ^ 1;
    EXPECT_DOUBLE_EQ(grips[opposite].place.dot(before.direction),
                     region_grips(kBox)[opposite].place.dot(before.direction));
  }
  EXPECT_DOUBLE_EQ(std::get<SphereRegion>(drag_grip(kSphere, 1, -0.1, 1e-6)).radius, 0.4 - 0.1);
}

TEST(RegionGrips, ThePlaneOfAHalfSpaceGoesAlongItsNormal) {
  const auto moved = std::get<HalfSpaceRegion>(drag_grip(kHalfSpace, 0, 0.5, 0));
  EXPECT_LT((moved.point - kHalfSpace.point - 0.5 * kHalfSpace.normal.normalized()).norm(), 2e-9);
  EXPECT_EQ(moved.normal, kHalfSpace.normal);
}

TEST(RegionGrips, LeaveARegionThatSceneFilesCanHave) {
  for (const Region& region : {Region(kBox), Region(kSphere), Region(kHalfSpace)}) {
    for (std::size_t grip = 0; grip < region_grips(region).size(); ++grip) {
      for (const double way : {-1e9, 1e9}) {
        Scene scene = placed_scene();
        Region& dragged = scene.bodies[1].supports[0].region;
        dragged = drag_grip(region, grip, way, 1e-6);
        EXPECT_TRUE(check_scene_text(scene_to_json(scene), "scene").empty());
        move_region(dragged, Vec3(way, 0, -way));
        EXPECT_TRUE(check_scene_text(scene_to_json(scene), "scene").empty());
      }
    }
  }
}

TEST(RegionGrips, LeaveAValidRegionHoweverFarTheyAreDragged) {
  for (std::size_t grip = 0; grip < 6; ++grip) {
    const auto box = std::get<BoxRegion>(drag_grip(kBox, grip, -1e9, 1e-6));
    EXPECT_TRUE((box.minimum.array() <= box.maximum.array()).all());
  }
  EXPECT_EQ(std::get<SphereRegion>(drag_grip(kSphere, 0, -1e9, 1e-6)).radius, 1e-6);
}

TEST(EntryPlaces, GoWhereTheyAreMovedTo) {
  for (const SceneEntry& entry : scene_entries(placed_scene())) {
    Scene scene = placed_scene();
    const std::optional<Placement> from = placement_of(scene, entry);
    ASSERT_TRUE(from) << full_name(scene, entry);
    Placement to = *from;
    to.position += Vec3(0.5, -1, 0.25);
    move_entry(scene, entry, *from, to);
    EXPECT_LT((placement_of(scene, entry)->position - to.position).norm(), 2e-9) << full_name(scene, entry);
    EXPECT_TRUE(check_scene_text(scene_to_json(scene), "scene").empty());
    for (const SceneEntry& other : scene_entries(scene)) {
      if (other == entry || (entry.kind == EntryKind::body && body_of(scene, other) == entry.index)) continue;
      EXPECT_EQ(placement_of(scene, other), placement_of(placed_scene(), other)) << full_name(scene, other);
    }
  }
}

TEST(EntryPlaces, AShotIsTurnedAboutWhereItStarts) {
  Scene scene = placed_scene();
  const SceneEntry shot{EntryKind::projectile, 0};
  const Placement from = *placement_of(scene, shot);
  move_entry(scene, shot, from, {from.position, Vec3(0, 90, 0)});
  EXPECT_LT((scene.projectiles[0].direction - Vec3(-1, 0, 0)).norm(), 1e-12);
  EXPECT_EQ(scene.projectiles[0].position, from.position);
}

TEST(EntryPlaces, ListsOfNodesHaveNone) {
  Scene scene = placed_scene();
  scene.bodies[1].supports[0].region = NodeListRegion{{0, 1}};
  EXPECT_FALSE(placement_of(scene, {EntryKind::support, 0, 1}));
  scene.probes[0].at = ProbeNode{3};
  EXPECT_FALSE(placement_of(scene, {EntryKind::probe, 0}));
  scene.probes[1].body = "nobody";
  EXPECT_FALSE(placement_of(scene, {EntryKind::probe, 1}));
}

/// The panels with a support of a turned body chosen.
class RegionTest : public ::testing::Test {
 protected:
  RegionTest() {
    ViewCamera& camera = ui_.input.views[0].camera;
    camera.eye = Vec3(4, 4, 9);
    camera.forward = (Vec3(1, 2, 3) - camera.eye).normalized();
    camera.right = camera.forward.cross(Vec3::UnitY()).normalized();
    camera.up = camera.right.cross(camera.forward);
    ui_.input.high = Vec3(2, 2, 2);
    ui_.frame();
    ui_.click("bodies/1/supports/0");
  }
  const BoxRegion& box() const { return std::get<BoxRegion>(ui_.history.scene().bodies[1].supports[0].region); }
  UiDriver ui_{placed_scene()};
};

TEST_F(RegionTest, AFaceFollowsTheCursorInOneEntryThatIsUndone) {
  ui_.drag("region/3", 5, -50);
  EXPECT_NE(box().maximum.y(), kBox.maximum.y());
  EXPECT_EQ(box().minimum, kBox.minimum);
  EXPECT_EQ(box().maximum.x(), kBox.maximum.x());
  ASSERT_EQ(ui_.history.entries().size(), 1u);
  EXPECT_EQ(ui_.history.entries()[0].label, "Set region of Support 1 of right");
  ui_.history.undo();
  EXPECT_EQ(ui_.history.scene(), placed_scene());
}

TEST_F(RegionTest, TheGripStaysUnderTheCursorThatGoesAlongItsWay) {
  const ImVec2 start = ui_.find("region/3");
  const Pose pose = pose_of(ui_.history.scene().bodies[1]);
  const RegionGrip grip = region_grips(kBox)[3];
  ViewCamera camera = ui_.input.views[0].camera;
  camera.width = ui_.state.viewport_size.x, camera.height = ui_.state.viewport_size.y;
  const Vec2 wanted = *camera.pixel(pose.to_world(grip.place + 0.5 * grip.direction));
  const ImVec2 low = ui_.state.viewport_minimum;
  ui_.drag("region/3", low.x + static_cast<float>(wanted.x()) - start.x,
           low.y + static_cast<float>(wanted.y()) - start.y);
  EXPECT_NEAR(box().maximum.y(), kBox.maximum.y() + 0.5, 0.02);
}

TEST_F(RegionTest, EscapeAndAClickLeaveItAsItWas) {
  ui_.click("region/3");
  ui_.move(ui_.find("region/3"));
  ui_.press(0, true);
  ui_.move({ImGui::GetIO().MousePos.x, ImGui::GetIO().MousePos.y - 60});
  ASSERT_TRUE(ui_.state.region_drag);
  EXPECT_NE(ui_.state.region_drag->region, ui_.state.region_drag->start);
  ui_.press_key(key::kEscape);
  ui_.press(0, false);
  EXPECT_FALSE(ui_.state.region_drag);
  EXPECT_EQ(ui_.history.scene(), placed_scene());
  EXPECT_TRUE(ui_.history.entries().empty());
  EXPECT_TRUE(ui_.commands.empty()) << "no node is picked through it";
}

TEST_F(RegionTest, ControlTakesRoundSteps) {
  ui_.queue.key(key::kLeftControl, true);
  ui_.drag("region/3", 5, -61);
  ui_.queue.key(key::kLeftControl, false);
  const double steps = box().maximum.y() / 0.05;
  EXPECT_NEAR(steps, std::round(steps), 1e-9);
  EXPECT_NE(box().maximum.y(), kBox.maximum.y());
}

TEST_F(RegionTest, StandsAtTheStartOfTimeAlone) {
  EXPECT_NE(find_tag(ui_.tags, "region/0"), nullptr);
  ui_.input.frame.step = 3;
  ui_.frame();
  EXPECT_EQ(find_tag(ui_.tags, "region/0"), nullptr);
}

TEST_F(RegionTest, TheGizmoMovesAllThatIsChosenButNothingTwice) {
  ui_.state.gizmo = GizmoTool::place;
  // The load of a chosen body goes with it.
  ui_.state.entries = {{EntryKind::load, 0, 1}, {EntryKind::projectile, 0}, {EntryKind::body, 1}};
  ui_.frame();
  ui_.drag("gizmo/move_x", 60, 10);
  const Scene &moved = ui_.history.scene(), before = placed_scene();
  const Vec3 way = moved.bodies[1].position - before.bodies[1].position;
  EXPECT_NE(way.x(), 0);
  EXPECT_LT((moved.projectiles[0].position - before.projectiles[0].position - way).norm(), 1e-12);
  EXPECT_EQ(moved.bodies[1].loads, before.bodies[1].loads);
  ASSERT_EQ(ui_.history.entries().size(), 1u);
  EXPECT_EQ(ui_.history.entries()[0].label, "Move right and 1 more");
  ui_.history.undo();
  EXPECT_EQ(ui_.history.scene(), before);
}

TEST_F(RegionTest, TheGizmoMovesARegionAndOffersNoRings) {
  ui_.state.gizmo = GizmoTool::place;
  ui_.frame();
  EXPECT_EQ(find_tag(ui_.tags, "gizmo/turn_y"), nullptr);
  const Vec3 before = placement_of(ui_.history.scene(), {EntryKind::support, 0, 1})->position;
  ui_.drag("gizmo/move_y", 0, -40);
  const Vec3 way = placement_of(ui_.history.scene(), {EntryKind::support, 0, 1})->position - before;
  EXPECT_GT(way.y(), 0);
  EXPECT_NEAR(way.x(), 0, 2e-9);
  EXPECT_NEAR(way.z(), 0, 2e-9);
}

}  // namespace
}  // namespace griffith::ui
