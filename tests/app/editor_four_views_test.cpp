// Four views of one scene: what they draw, and picking, grabs and shots in them.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "editor_fixture.h"

namespace griffith::app {
namespace {

/// Center of a view in the viewport, 0..1.
const Vec2 kCamera(0.75, 0.25), kTop(0.25, 0.25), kFront(0.25, 0.75), kRight(0.75, 0.75);

class FourViewsOfAWallTest : public EditorTest {
 protected:
  FourViewsOfAWallTest() {
    editor_.execute({.name = "view.frame_all"});
    press_key('Q', true, false, true);
    draw(3);
  }
  bool draws() { return editor_.viewport().draw(editor_.run().shown(), 1); }
  /// Picks at a point of the viewport. Returns the center of the picked tet.
  Vec3 picked(const Vec2& cursor) {
    editor_.execute({.name = "view.pick", .cursor = cursor});
    const ui::Selection selection = editor_.state().selection;
    if (!selection.valid()) return Vec3::Constant(std::nan(""));
    const Frame frame = editor_.run().frame();
    Vec3 center = Vec3::Zero();
    for (const NodeId node : frame.elements.tets[selection.tet]) center += frame.nodes.positions[node] / 4;
    return center;
  }
  /// Returns the views as the panels get them.
  ui::EditorInput described() {
    ui::EditorInput input;
    input.fonts = imgui_.fonts();
    input.frame = editor_.run().frame();
    editor_.viewport().describe(input, editor_.document().scene());
    return input;
  }
};

TEST_F(FourViewsOfAWallTest, EachLooksFromItsSideAtTheSamePlace) {
  const ui::EditorInput input = described();
  const Vec3 toward[] = {Vec3::Zero(), Vec3::UnitY(), Vec3::UnitZ(), Vec3::UnitX()};
  const double height = static_cast<double>(render::height_at_target(editor_.viewport().camera()));
  const Vec3 target = editor_.viewport().camera().target.cast<double>();
  for (std::size_t view = 1; view < 4; ++view) {
    const ui::ViewCamera& camera = input.views[view].camera;
    EXPECT_TRUE(input.views[view].picture);
    EXPECT_TRUE(camera.forward.isApprox(-toward[view], 1e-6));
    EXPECT_NEAR((target - camera.eye).cross(camera.forward).norm(), 0, 1e-3 * height);
    EXPECT_GT((target - camera.eye).norm(), 20 * height) << "nearly parallel";
  }
}

TEST_F(FourViewsOfAWallTest, PicksWhatIsSeenInEach) {
  const Frame frame = editor_.run().frame();
  Vec3 high = Vec3::Constant(-1e9);
  for (const Vec3& place : frame.nodes.positions) high = high.cwiseMax(place);
  EXPECT_GT(picked(kTop).y(), 0.6 * high.y());
  EXPECT_GT(picked(kFront).z(), 0);
  EXPECT_GT(picked(kRight).x(), 0);
  EXPECT_TRUE(picked(kCamera).allFinite());
  EXPECT_FALSE(picked(Vec2(0.01, 0.99)).allFinite()) << "beside it";
}

TEST_F(FourViewsOfAWallTest, NothingIsDrawnAgainWhileNothingChanges) {
  EXPECT_FALSE(draws());
  draw(3);
  const render::Image before = window_image();
  draw(2);
  EXPECT_EQ(window_image(), before);
  editor_.viewport().look_from(Vec3(3, 3, 9), Vec3(0, 1, 0));
  EXPECT_TRUE(draws());
  EXPECT_FALSE(draws());
}

TEST_F(FourViewsOfAWallTest, PansAndZoomsOfASideMoveAllViews) {
  const render::Camera before = editor_.viewport().camera();
  editor_.state().four_views.active = 1;
  editor_.state().camera_motion.pan_right = 0.5f;
  editor_.state().camera_motion.yaw = 1;
  editor_.viewport().follow_mouse(false);
  const render::Camera after = editor_.viewport().camera();
  const Eigen::Vector3f moved = after.target - before.target;
  const float height = render::height_at_target(before);
  EXPECT_TRUE(moved.isApprox(Eigen::Vector3f(0.5f * height, 0, 0), 1e-3f)) << moved.transpose();
  EXPECT_TRUE((after.position - before.position).isApprox(moved, 1e-3f)) << "sides do not rotate";
}

TEST_F(FourViewsOfAWallTest, AGrabFromAboveIsDraggedLevel) {
  editor_.execute({.name = "simulation.grab_at", .cursor = kTop});
  ASSERT_TRUE(editor_.state().holds_piece);
  const Vec3 from = editor_.run().target();
  editor_.execute({.name = "simulation.drag_to", .cursor = Vec2(0.35, 0.3)});
  const Vec3 to = editor_.run().target();
  EXPECT_NEAR(to.y(), from.y(), 1e-3 * (to - from).norm() + 1e-3);
  EXPECT_GT(to.x(), from.x());
  EXPECT_GT(to.z(), from.z());
  editor_.execute({.name = "simulation.drag_to", .cursor = kRight});
  EXPECT_NEAR(editor_.run().target().y(), from.y(), 1e-2 * (to - from).norm() + 1e-2) << "also beyond its view";
}

TEST_F(FourViewsOfAWallTest, ShotsComeFromTheSideOfTheView) {
  const AimedShot shot = editor_.viewport().aimed_at(editor_.run().frame(), editor_.document().scene(), kFront);
  const double height = static_cast<double>(render::height_at_target(editor_.viewport().camera()));
  EXPECT_GT(shot.shot.position.z(), shot.target.z());
  EXPECT_LT((shot.shot.position - shot.target).norm(), 3 * height);
}

TEST_F(FourViewsOfAWallTest, AViewShowsAQuantityOfItsOwn) {
  editor_.state().view.quantity = "material";
  editor_.state().four_views.quantities[2] = "speed";
  draw(2);
  ui::EditorInput input = described();
  EXPECT_FALSE(input.views[0].legend);
  EXPECT_FALSE(input.views[1].legend);
  ASSERT_TRUE(input.views[2].legend);
  EXPECT_EQ(input.views[2].legend->unit, "m/s");
  EXPECT_FALSE(draws());
  EXPECT_EQ(editor_.viewport().exported_view(editor_.run().built()).view.quantity, "material");
}

TEST_F(FourViewsOfAWallTest, OneViewShowsWhatItDidBefore) {
  press_key('Q', true, false, true);
  draw(3);
  const render::Image one = window_image();
  press_key('Q', true, false, true);
  draw(3);
  EXPECT_FALSE(window_image() == one);
  press_key('Q', true, false, true);
  draw(3);
  EXPECT_EQ(window_image(), one);
}

}  // namespace
}  // namespace griffith::app
