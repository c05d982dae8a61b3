#include "app/picture/scene_legend.h"

#include <gtest/gtest.h>

#include "app/editor/imgui_context_owner.h"
#include "app/picture/draw_scene_from_frame.h"
#include "app/picture/picture_options.h"
#include "app/picture/scene_camera.h"
#include "renderer/egl_context.h"
#include "sim/scene/scene_reader.h"
#include "sim/world/world.h"

namespace griffith::app {
namespace {

using Eigen::AlignedBox2f, Eigen::Vector2f;

const ImVec2 kSize = {1280, 720};

TEST(CoveredShare, CountsWhatIsSeenInThePartAlone) {
  const render::Camera camera = {{0, 0, 5}, {0, 0, 0}, 90};  // sees 10 m by 10 m through its target
  render::DrawScene picture;
  picture.surface.positions = {{-5, -5, 0}, {0, -5, 0}, {0, 5, 0}, {-5, -5, 0}, {0, 5, 0}, {-5, 5, 0}};
  const auto covered = [&](float x0, float y0, float x1, float y1) {
    return covered_fraction(picture, camera, 1, AlignedBox2f(Vector2f(x0, y0), Vector2f(x1, y1)));
  };
  EXPECT_EQ(covered(0.05f, 0.1f, 0.45f, 0.6f), 1);
  EXPECT_EQ(covered(0.55f, 0.1f, 0.95f, 0.6f), 0);
  EXPECT_NEAR(covered(0.3f, 0.1f, 0.7f, 0.6f), 0.5, 0.07);
  picture.surface.positions.clear();
  picture.spheres = {{{3, 3, 0}, 1}};
  EXPECT_GT(covered(0.7f, 0.1f, 0.9f, 0.3f), 0.5f);
  EXPECT_EQ(covered(0.1f, 0.7f, 0.3f, 0.9f), 0);
  picture.spheres[0].center.z() = 9;  // behind the camera
  EXPECT_EQ(covered(0, 0, 1, 1), 0);
}

TEST(ScalingLabel, SaysWhatBrokeScaled) {
  Scene scene;
  scene.bodies.resize(2);
  scene.bodies[0].name = "pane";
  std::vector<BodyView> bodies(2);
  bodies[0].tets = bodies[1].tets = 1;
  bodies[1].scene_body = 1;
  Frame frame;
  frame.bodies = bodies;
  EXPECT_FALSE(scaling_label(scene, frame, 0.9f));
  bodies[0].broke_scaled.emplace().factor = 1.0 / 16;
  const std::optional<ui::PictureLabel> label = scaling_label(scene, frame, 0.9f);
  ASSERT_TRUE(label);
  EXPECT_EQ(label->text, "pane broke at E/256, σ/16");
  EXPECT_EQ(label->y, 0.9f);
  bodies[1].broke_scaled.emplace().factor = 0.5;
  EXPECT_EQ(scaling_label(scene, frame, 0.9f)->text, "2 bodies broke scaled, down to E/256, σ/16");
  scene.bodies.clear();  // edited, while the world is of before
  EXPECT_TRUE(scaling_label(scene, frame, 0.9f));
}

class LegendCornerTest : public ::testing::Test {
 protected:
  /// Returns the fraction of its card that the legend covers in the scene's first picture.
  float covered(const std::string& scene_file, ui::LegendCorner* chosen = nullptr) {
    const Scene scene = read_scene(std::filesystem::path(GRIFFITH_SOURCE_DIR) / "scenes" / scene_file);
    const World world(scene);
    const Frame frame = world.frame();
    const render::DrawScene picture =
        draw_scene_from_frame(frame, embedded_display(frame, scene), scene, scene.view, {});
    const render::Camera camera = scene_camera(scene, "", picture, kSize.x / kSize.y);
    ui::Legend legend = *scene_legend(picture, false);
    legend.corner = legend_corner(picture, camera, legend, imgui_.fonts(), kSize, 1);
    if (chosen) *chosen = legend.corner;
    const auto [low, high] = ui::legend_card(legend, legend.corner, imgui_.fonts(), {{0, 0}, kSize}, 1);
    const AlignedBox2f part(Vector2f(low.x / kSize.x, low.y / kSize.y), Vector2f(high.x / kSize.x, high.y / kSize.y));
    return covered_fraction(picture, camera, kSize.x / kSize.y, part);
  }

  render::EglContext context_;
  ImGuiContextOwner imgui_{1};
};

TEST_F(LegendCornerTest, CoversNothingInScenesWhoseBodiesReachIntoTheUsualCorner) {
  for (const char* scene : {"materials.json", "walls_4.json", "walls_16.json"}) {
    ui::LegendCorner corner = {};
    EXPECT_EQ(covered(scene, &corner), 0) << scene;
    EXPECT_NE(corner, ui::LegendCorner::upper_right) << scene;
  }
}

TEST_F(LegendCornerTest, StaysWhereItIsWhileItCoversNothing) {
  ui::Legend legend{"stress", "Pa", 0, 3e6, {}};
  legend.corner = ui::LegendCorner::lower_left;
  EXPECT_EQ(legend_corner({}, {}, legend, imgui_.fonts(), kSize, 1), ui::LegendCorner::lower_left);
}

TEST_F(LegendCornerTest, CardGrowsWithThePicture) {
  const ui::Legend legend{"stress", "Pa", 0, 3e6, {}};
  EXPECT_EQ(writing_scale(1280, 720), 1);
  EXPECT_EQ(writing_scale(7680, 4320), 6);
  EXPECT_EQ(writing_scale(720, 1280), 0.8f);  // narrow, but legible
  for (const ui::LegendCorner corner : ui::kLegendCorners) {
    const auto small = ui::legend_card(legend, corner, imgui_.fonts(), {{0, 0}, kSize}, 1);
    const auto large = ui::legend_card(legend, corner, imgui_.fonts(), {{0, 0}, {7680, 4320}}, 6);
    EXPECT_NEAR(large.minimum.x, 6 * small.minimum.x, 12);
    EXPECT_NEAR(large.maximum.x, 6 * small.maximum.x, 12);
    EXPECT_NEAR(large.minimum.y, 6 * small.minimum.y, 12);
    EXPECT_NEAR(large.maximum.y, 6 * small.maximum.y, 12);
    EXPECT_GE(small.minimum.x, 0);
    EXPECT_LE(small.maximum.y, kSize.y);
  }
}

TEST_F(LegendCornerTest, CardHasRoomForAHistogramInLargePicturesAlone) {
  const ui::Legend plain{"stress", "Pa", 0, 3e6, {}};
  ui::Legend counted = plain;
  counted.histogram = {1, 2, 3};
  const auto width = [&](const ui::Legend& legend, ImVec2 size) {
    const auto [low, high] = ui::legend_card(legend, legend.corner, imgui_.fonts(), {{0, 0}, size}, 0.8f);
    return high.x - low.x;
  };
  EXPECT_GT(width(counted, {640, 360}), width(plain, {640, 360}));
  EXPECT_EQ(width(counted, {320, 180}), width(plain, {320, 180}));
}

}  // namespace
}  // namespace griffith::app
