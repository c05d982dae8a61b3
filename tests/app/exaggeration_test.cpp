#include "app/picture/exaggeration.h"

#include <gtest/gtest.h>

#include "app/picture/draw_scene_from_frame.h"
#include "program.h"
#include "sim/world/world.h"

namespace griffith::app {
namespace {

/// A frame of a world with the nodes elsewhere.
struct MovedFrame {
  explicit MovedFrame(const World& world) : frame(world.frame()) {
    positions.assign(frame.nodes.rest_positions.begin(), frame.nodes.rest_positions.end());
    free.assign(positions.size(), NodeConstraint());
    frame.nodes.positions = positions;
    frame.nodes.constraints = free;
  }
  template <class Map>
  void move(const Map& map) {
    for (Vec3& position : positions) position = map(position);
  }

  Frame frame;
  std::vector<Vec3> positions;
  std::vector<NodeConstraint> free;
};

TEST(Exaggeration, AFactorOfOneChangesNoBit) {
  World world(small_wall());
  for (int step = 0; step < 20; ++step) world.step();
  const Frame frame = world.frame();
  const std::vector<Vec3> shown = exaggerated_positions(frame, 1);
  for (std::size_t i = 0; i < shown.size(); ++i) EXPECT_EQ(shown[i], frame.nodes.positions[i]);
  EXPECT_TRUE(draw_scene_from_frame(frame, embedded_display(frame, small_wall()), small_wall(), {}, {}).labels.empty());
}

TEST(Exaggeration, ARigidMotionIsNotExaggerated) {
  const World world(small_wall());
  MovedFrame moved(world);
  const Mat3 turn = Eigen::AngleAxisd(2.1, Vec3(1, 2, -1).normalized()).toRotationMatrix();
  moved.move([&](const Vec3& place) { return Vec3(turn * place + Vec3(3, -1, 2)); });
  const std::vector<Vec3> shown = exaggerated_positions(moved.frame, 1000);
  for (std::size_t i = 0; i < shown.size(); ++i) EXPECT_LT((shown[i] - moved.positions[i]).norm(), 1e-9);
}

TEST(Exaggeration, AStretchIsMultiplied) {
  const World world(small_wall());
  const auto width = [](const std::vector<Vec3>& places) {
    double low = 1e300, high = -1e300;
    for (const Vec3& place : places) low = std::min(low, place.x()), high = std::max(high, place.x());
    return high - low;
  };
  MovedFrame moved(world);
  const double rest = width(moved.positions);
  moved.move([](const Vec3& place) { return Vec3(1.001 * place.x(), place.y(), place.z()); });
  for (const double factor : {0.0, 2.0, 50.0})
    EXPECT_NEAR(width(exaggerated_positions(moved.frame, factor)), (1 + 0.001 * factor) * rest, 1e-9 * rest);
}

TEST(Exaggeration, HeldNodesStayAndPlacesThatAreNotFiniteToo) {
  const World world(small_wall());
  MovedFrame moved(world);
  const auto is_low = [](const Vec3& place) { return place.y() < 1e-9; };
  for (std::size_t i = 0; i < moved.free.size(); ++i)
    if (is_low(moved.positions[i])) moved.free[i] = NodeConstraint::held();
  moved.move([](const Vec3& place) { return Vec3(place.x() + 0.01 * place.y() * place.y(), place.y(), place.z()); });
  moved.positions.back().setConstant(NAN);
  const std::vector<Vec3> shown = exaggerated_positions(moved.frame, 100);
  EXPECT_TRUE(shown.back().hasNaN());
  for (std::size_t i = 0; i + 1 < shown.size(); ++i) {
    const Vec3& rest = moved.frame.nodes.rest_positions[i];
    EXPECT_LT((shown[i] - Vec3(rest.x() + rest.y() * rest.y(), rest.y(), rest.z())).norm(), 1e-4);
  }
}

TEST(Exaggeration, APictureReportsItsFactor) {
  World world(small_wall());
  ViewSettings view;
  view.deformation_scale = 50;
  const Frame frame = world.frame();
  const auto picture = draw_scene_from_frame(frame, embedded_display(frame, small_wall()), small_wall(), view, {});
  ASSERT_EQ(picture.labels.size(), 1u);
  EXPECT_EQ(picture.labels[0].text, "deformation × 50");
}

}  // namespace
}  // namespace griffith::app
