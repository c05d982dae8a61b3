#include "app/picture/exposure.h"

#include <gtest/gtest.h>

#include "renderer/camera.h"
#include "sim/world/world.h"
#include "tests/app/program.h"

namespace griffith::app {
namespace {

constexpr int kCount = 48, kTimes = 12;

TEST(Exposures, CoverLensPixelAndShutterEvenly) {
  const std::vector<Exposure> all = exposures(kCount, kTimes);
  ASSERT_EQ(all.size(), std::size_t{kCount});
  Eigen::Vector2f lens = Eigen::Vector2f::Zero(), pixel = Eigen::Vector2f::Zero();
  double time = 0, square = 0;
  for (const Exposure& one : all) {
    lens += one.lens / kCount;
    pixel += one.pixel / kCount;
    time += one.time / kCount;
    square += one.lens.squaredNorm() / kCount;
    EXPECT_LE(one.lens.norm(), 1);
    EXPECT_LE(one.pixel.cwiseAbs().maxCoeff(), 0.5f);
  }
  EXPECT_LT(lens.norm(), 0.05f);
  EXPECT_LT(pixel.norm(), 0.05f);
  EXPECT_NEAR(time, -0.5, 1e-12);
  EXPECT_NEAR(square, 0.5, 1e-6) << "mean square of the distance from the center of a disc";
}

TEST(Exposures, KeepWhatIsAsFarAsTheTargetInItsPlace) {
  const render::Camera camera;
  for (Exposure one : exposures(kCount, kTimes)) {
    one.pixel.setZero();
    const render::Camera moved = exposed(camera, one, 720);
    EXPECT_EQ(moved.target, camera.target);
    EXPECT_NEAR((moved.position - camera.position).norm(), lens_radius(camera) * one.lens.norm(), 1e-5f);
  }
}

TEST(Exposures, BlurNearThingsInProportionAndLargeOnesAsACameraDoes) {
  const auto radius_at = [](float distance) {
    render::Camera camera;
    camera.position = camera.target + distance * Eigen::Vector3f::UnitZ();
    return lens_radius(camera);
  };
  EXPECT_NEAR(radius_at(0.2f), 2 * radius_at(0.1f), 1e-7f);
  EXPECT_EQ(radius_at(40), radius_at(20));
  EXPECT_LT(radius_at(20), 0.02f) << "a lens that a hand can hold [m]";
}

TEST(FrameLater, IsWhereConstantVelocitiesLead) {
  World world(small_wall());
  for (int step = 0; step < 6; ++step) world.step();
  const Frame frame = world.frame();
  const LaterFrame moved(frame, -0.01);
  ASSERT_FALSE(frame.projectiles.empty());
  EXPECT_EQ(moved.frame().projectiles[0].position,
            frame.projectiles[0].position - 0.01 * frame.projectiles[0].velocity);
  for (std::size_t i = 0; i < frame.nodes.positions.size(); ++i) {
    const NodeId node(static_cast<std::int64_t>(i));
    EXPECT_EQ(moved.frame().nodes.positions[node], frame.nodes.positions[node] - 0.01 * frame.nodes.velocities[node]);
  }
}

TEST(ImageSum, MeansLightNotBytes) {
  const auto gray = [](std::uint8_t value) { return render::Image{1, 1, {value, value, value, 255}}; };
  ImageSum same, mixed;
  for (int i = 0; i < 3; ++i) same.add(gray(77));
  EXPECT_EQ(same.mean(), gray(77));
  mixed.add(gray(0));
  mixed.add(gray(255));
  EXPECT_EQ(mixed.mean(), gray(188)) << "half of the light in the sRGB encoding";
}

}  // namespace
}  // namespace griffith::app
