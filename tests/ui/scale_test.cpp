// Scaling: laws of volumes, cells and regions; handles; what cannot be scaled.

#include <gtest/gtest.h>

#include <cmath>

#include "sim/scene/body_pose.h"
#include "sim/scene/shape_fields.h"
#include "ui/model/entry_scale.h"
#include "ui/model/gizmo_scale.h"
#include "ui_driver.h"

namespace griffith::ui {
namespace {

const SceneEntry kFirst{EntryKind::body, 0};

double volume_of(const Shape& shape) { return extents_of(shape)->prod(); }

TEST(ScaledShape, VolumesFollowTheFactorsAndElementsKeepTheirSize) {
  const Shape shapes[] = {BoxShape{},    CylinderShape{},      DiscShape{},
                          SphereShape{}, PlateWithHoleShape{}, NotchedBeamShape{}};
  for (const Shape& shape : shapes) {
    const ScaleGroups groups = scale_groups(shape);
    const Vec3 of_groups(1.5, 0.8, 3), factors(of_groups[groups[0]], of_groups[groups[1]], of_groups[groups[2]]);
    Shape scaled = shape;
    scale_lengths(scaled, factors);
    EXPECT_NEAR(volume_of(scaled), factors.prod() * volume_of(shape), 1e-9);
    Shape twice = shape;
    scale_lengths(twice, Vec3::Constant(2));
    EXPECT_NEAR(tet_count(twice), 8 * tet_count(shape), 0.2 * tet_count(twice)) << "of the same elements";
    scale_elements(twice, Vec3::Constant(2));
    EXPECT_EQ(tet_count(twice), tet_count(shape)) << "of larger ones";
  }
}

TEST(ScaledShape, ScalingBackGivesTheSameNumbers) {
  const BoxShape box{Vec3(0.3, 0.7, 1.1), Vec3::Constant(0.05), BoxPattern::kuhn};
  Shape shape = box;
  for (const double factor : {1.1, 7.0, 0.3}) {
    scale_lengths(shape, Vec3(factor, 1, 1 / factor));
    scale_lengths(shape, Vec3(1 / factor, 1, factor));
    EXPECT_EQ(std::get<BoxShape>(shape), box) << factor;
  }
}

TEST(EntryScale, RegionsAndProbesStayOnTheSameMaterial) {
  Scene scene = two_walls();
  BodyDescription& body = scene.bodies[0];
  const Vec3 half = std::get<BoxShape>(body.shape).size / 2, factors(2, 0.5, 3);
  body.supports = {{HalfSpaceRegion{Vec3(0, -half.y(), 0), -Vec3::UnitY()}}};
  body.loads = {{BoxRegion{Vec3(-half.x(), half.y(), -half.z()), half}}};
  Probe probe = probe_of("left", "corner");
  probe.at = ProbePoint{half};
  scene.probes = {probe};
  scale_entry(scene, kFirst, factors);
  const Vec3 scaled = std::get<BoxShape>(scene.bodies[0].shape).size / 2;
  EXPECT_EQ(scaled, half.cwiseProduct(factors));
  EXPECT_EQ(std::get<HalfSpaceRegion>(scene.bodies[0].supports[0].region).point.y(), -scaled.y());
  EXPECT_EQ(std::get<BoxRegion>(scene.bodies[0].loads[0].region).maximum, scaled);
  EXPECT_EQ(std::get<ProbePoint>(scene.probes[0].at).point, scaled);
  EXPECT_EQ(scene.bodies[1], two_walls().bodies[1]);
}

TEST(EntryScale, SaysWhatCannotBeScaled) {
  Scene scene = two_walls();
  EXPECT_EQ(scale_problem(scene, kFirst), "");
  scene.bodies[0].supports = {{NodeListRegion{{1, 2}}}, {HalfSpaceRegion{}}};
  EXPECT_NE(scale_problem(scene, kFirst), "") << "its nodes would get other numbers";
  EXPECT_NE(scale_problem(scene, {EntryKind::support, 0, 0}), "");
  EXPECT_NE(scale_problem(scene, {EntryKind::support, 1, 0}), "");
  scene.bodies[0].shape = MeshFileShape{};
  EXPECT_EQ(scale_problem(scene, kFirst), "") << "a mesh keeps its nodes";
  scene.bodies[1].residual_stress = StrainFile{};
  EXPECT_NE(scale_problem(scene, {EntryKind::body, 1}), "");
  scene.cameras = {{}};
  EXPECT_NE(scale_problem(scene, {EntryKind::camera, 0}), "");
  scene.probes = {probe_of("left", "tip")};
  EXPECT_NE(scale_problem(scene, {EntryKind::probe, 0}), "");
}

/// The panels with the handles that scale the first body.
class ScaleTest : public ::testing::Test {
 protected:
  ScaleTest() {
    ui_.input.views[0].camera.eye = Vec3(3, 2, 4);
    ui_.input.views[0].camera.forward = -ui_.input.views[0].camera.eye.normalized();
    ui_.input.views[0].camera.right = ui_.input.views[0].camera.forward.cross(Vec3::UnitY()).normalized();
    ui_.input.views[0].camera.up = ui_.input.views[0].camera.right.cross(ui_.input.views[0].camera.forward);
    ui_.input.high = Vec3(2, 2, 2);
    ui_.state.gizmo = GizmoTool::scale;
    ui_.frame();
  }
  Vec3 size(std::size_t body = 0) const { return std::get<BoxShape>(ui_.history.scene().bodies[body].shape).size; }
  /// Returns the pixel of the handle's middle, the place of the body.
  ImVec2 middle() const {
    return {ui_.state.viewport_minimum.x + ui_.state.viewport_size.x / 2,
            ui_.state.viewport_minimum.y + ui_.state.viewport_size.y / 2};
  }
  /// Drags a handle to `factor` times its distance from the middle.
  void pull(const std::string& tag, float factor) {
    const ImVec2 grip = ui_.find(tag), center = middle();
    ui_.drag(tag, (factor - 1) * (grip.x - center.x), (factor - 1) * (grip.y - center.y));
  }

  UiDriver ui_{two_walls()};
};

TEST_F(ScaleTest, AnAxisScalesAlongItAloneByTheRatioOfDistances) {
  for (int axis = 0; axis < 3; ++axis) {
    const Vec3 before = size();
    pull(std::string("gizmo/scale_") + "xyz"[axis], 1.5f);
    for (int other = 0; other < 3; ++other)
      EXPECT_NEAR(size()[other], (other == axis ? 1.5 : 1) * before[other], other == axis ? 0.08 : 0) << axis << other;
    EXPECT_EQ(ui_.history.scene().bodies[0].position, Vec3::Zero());
    ui_.history.undo();
    EXPECT_EQ(ui_.history.scene(), two_walls());
    ui_.frame();
  }
}

TEST_F(ScaleTest, TheRingScalesAllSelectedEntriesAndTheirDistances) {
  ui_.history.change("move", [](Scene& scene) { scene.bodies[1].position = Vec3(2, 1, 0); });
  ui_.history.finish();
  ui_.state.entries = {{EntryKind::body, 1}, kFirst};
  ui_.frame();
  const std::size_t edits = ui_.history.entries().size();
  pull("gizmo/scale", 2);
  const double factor = size().x();
  EXPECT_NEAR(factor, 2, 0.05);
  EXPECT_EQ(size(), Vec3::Constant(factor));
  EXPECT_EQ(size(1), size());
  EXPECT_LT((ui_.history.scene().bodies[1].position - factor * Vec3(2, 1, 0)).norm(), 1e-9);
  EXPECT_EQ(ui_.history.entries().size(), edits + 1);
  EXPECT_EQ(ui_.history.entries().back().label, "Scale left and 1 more");
}

TEST_F(ScaleTest, ARotatedBodyScalesAlongItsOwnAxes) {
  ui_.history.change("turn", [](Scene& scene) { scene.bodies[0].rotation_degrees = Vec3(0, 0, 90); });
  ui_.history.finish();
  ui_.frame();
  pull("gizmo/scale_x", 2);  // upright now
  EXPECT_NEAR(size().x(), 2, 0.1);
  EXPECT_EQ(size().y(), 1);
}

TEST_F(ScaleTest, ControlRoundsTheLength) {
  ui_.queue.key(key::kLeftControl, true);
  pull("gizmo/scale_x", 1.37f);
  ui_.queue.key(key::kLeftControl, false);
  constexpr double kStep = 0.05;  // bodies are 3.5 m across
  EXPECT_NEAR(size().x() / kStep, std::round(size().x() / kStep), 1e-9);
  EXPECT_NE(size().x(), 1);
}

TEST_F(ScaleTest, ShowsTheSizeTheFactorAndTheNumberOfElements) {
  const ImVec2 grip = ui_.find("gizmo/scale_y");
  ui_.move(grip);
  ui_.press(0, true);
  ui_.move({grip.x, grip.y - 60});
  const std::string text = ui_.value("gizmo/scale_y");
  EXPECT_EQ(text.substr(0, 2), "y ") << text;
  EXPECT_NE(text.find("(× "), std::string::npos) << text;
  EXPECT_NE(text.find("tetrahedra"), std::string::npos) << text;
  ui_.press_key(key::kEscape);
  ui_.press(0, false);
  EXPECT_EQ(ui_.history.scene(), two_walls()) << "cancelled";
}

TEST_F(ScaleTest, NothingBecomesFlatOrTurnsInsideOut) {
  const ImVec2 grip = ui_.find("gizmo/scale_x"), center = middle();
  ui_.drag("gizmo/scale_x", 3 * (center.x - grip.x), 3 * (center.y - grip.y));
  EXPECT_GT(size().x(), 0);
  EXPECT_LT(size().x(), 0.1);
}

TEST_F(ScaleTest, RoundShapesKeepRoundSections) {
  ui_.history.change("shape", [](Scene& scene) { scene.bodies[0].shape = CylinderShape{}; });
  ui_.history.finish();
  ui_.frame();
  pull("gizmo/scale_x", 1.5f);
  const auto cylinder = std::get<CylinderShape>(ui_.history.scene().bodies[0].shape);
  EXPECT_NEAR(cylinder.radius, 0.75, 0.05);
  EXPECT_EQ(cylinder.length, CylinderShape{}.length);
}

TEST_F(ScaleTest, AKeySwitchesBetweenTheHandles) {
  ui_.press_key('S');
  EXPECT_EQ(ui_.issued(), std::vector<std::string_view>{"edit.scale"});
  EXPECT_EQ(find_tag(ui_.tags, "gizmo/move_x"), nullptr);
  ui_.state.gizmo = GizmoTool::place;
  ui_.frame();
  EXPECT_EQ(find_tag(ui_.tags, "gizmo/scale_x"), nullptr);
  EXPECT_NE(find_tag(ui_.tags, "gizmo/move_x"), nullptr);
}

}  // namespace
}  // namespace griffith::ui
