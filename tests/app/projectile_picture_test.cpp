#include "app/picture/projectile_picture.h"

#include <gtest/gtest.h>

#include <array>

namespace griffith::app {
namespace {

/// A box of 2 x 1 x 1 m, or a ball of that mass.
class ProjectilePicture : public ::testing::Test {
 protected:
  render::DrawScene picture_of(double mass, bool box, bool natural) {
    view_.mass = mass;
    view_.position = {5, 6, 7};
    view_.rotation = Quat::Identity();
    view_.radius = box ? 1.5 : 1;
    view_.corners = {corners_.data(), box ? corners_.size() : 0};
    view_.faces = {faces_.data(), box ? faces_.size() : 0};
    const std::array views = {view_};
    Frame frame;
    frame.projectiles = views;
    render::DrawScene picture;
    add_projectiles(frame, natural, picture);
    return picture;
  }

  const std::vector<Vec3> corners_ = {{-1, -.5, -.5}, {1, -.5, -.5}, {1, .5, -.5}, {-1, .5, -.5},
                                      {-1, -.5, .5},  {1, -.5, .5},  {1, .5, .5},  {-1, .5, .5}};
  const std::vector<std::vector<int>> faces_ = {{3, 2, 1, 0}, {4, 5, 6, 7}, {0, 1, 5, 4},
                                                {1, 2, 6, 5}, {2, 3, 7, 6}, {3, 0, 4, 7}};
  ProjectileView view_;
};

TEST_F(ProjectilePicture, ABoxLooksLikeABallOfItsDensity) {
  constexpr double kBox = 2, kBall = 4.18879;  // volumes [m³]
  for (const double density : {1000.0, 2500.0, 7800.0, 11000.0}) {
    const render::Sphere ball = picture_of(density * kBall, false, true).spheres.at(0);
    const render::DrawScene box = picture_of(density * kBox, true, true);
    const render::EmbeddedMaterial& material = box.embedded.materials.at(0);
    EXPECT_EQ(material.metal, ball.metal) << density;
    EXPECT_EQ(material.blur, ball.roughness) << density;
    EXPECT_EQ(material.color.r, ball.color.r) << density;
    EXPECT_EQ(box.surface.colors.at(0).r, ball.color.r) << density;
  }
  EXPECT_EQ(picture_of(7800 * kBox, true, true).embedded.materials.at(0).metal, 1) << "steel";
  EXPECT_EQ(picture_of(1000 * kBox, true, true).embedded.materials.at(0).metal, 0);
}

TEST_F(ProjectilePicture, ABoxIsDrawnWithTwelveTrianglesInItsPlace) {
  const render::DrawScene picture = picture_of(1, true, true);
  ASSERT_EQ(picture.surface.positions.size(), 36u);
  EXPECT_EQ(picture.surface.rests.size(), 36u);
  EXPECT_EQ(picture.surface.matters, std::vector<std::int32_t>(12, 0));
  for (std::size_t i = 0; i < 36; ++i)
    EXPECT_EQ(picture.surface.positions[i], picture.surface.rests[i] + Eigen::Vector3f(5, 6, 7));
}

TEST_F(ProjectilePicture, ABoxIsPaintedAmongValues) {
  const render::DrawScene picture = picture_of(1e5, true, false);
  EXPECT_TRUE(picture.embedded.materials.empty());
  EXPECT_TRUE(picture.surface.matters.empty());
  EXPECT_EQ(picture.surface.flags, std::vector<std::uint8_t>(12, render::kPlain));
}

}  // namespace
}  // namespace griffith::app
