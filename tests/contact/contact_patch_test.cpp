#include "sim/contact/contact_patch.h"

#include <gtest/gtest.h>

#include "tests/contact/bodies.h"

namespace griffith {
namespace {

using testing::box_part;

std::vector<Vec3> moved(std::vector<Vec3> points, const Quat& turn, const Vec3& shift) {
  for (Vec3& point : points) point = turn * point + shift;
  return points;
}

Vec3 mean(const std::vector<PatchPoint>& patch) {
  Vec3 sum = Vec3::Zero();
  for (const PatchPoint& point : patch) sum += point.on_b / static_cast<double>(patch.size());
  return sum;
}

TEST(ContactPatch, OverlappingFacesMeetInTheirCommonArea) {
  std::mt19937 random(1);
  std::uniform_real_distribution<double> uniform(-1, 1);
  for (int trial = 0; trial < 50; ++trial) {
    const Quat turn(Eigen::AngleAxisd(3 * uniform(random), Vec3(uniform(random), 1, uniform(random)).normalized()));
    const Vec3 place(uniform(random), uniform(random), uniform(random));
    const Vec3 shift(0.4 * uniform(random), 0.4 * uniform(random), 1.01);
    const auto below = moved(box_part(Vec3(1, 1, 1)), turn, place);
    const auto above = moved(moved(box_part(Vec3(1, 1, 1)), Quat::Identity(), shift), turn, place);
    const auto patch = contact_patch(above, below, turn * Vec3::UnitZ(), 0.02);
    ASSERT_EQ(patch.size(), 4u);
    EXPECT_LT((turn.conjugate() * (mean(patch) - place) - Vec3(shift.x() / 2, shift.y() / 2, 0.5)).norm(), 1e-9);
    for (const PatchPoint& point : patch) EXPECT_NEAR(point.distance, 0.01, 1e-9);
  }
}

TEST(ContactPatch, ATiltedFaceIsNearerOnOneSide) {
  constexpr double kTilt = 0.01;
  const auto below = box_part(Vec3(3, 3, 1));
  const auto above =
      moved(box_part(Vec3(1, 1, 1)), Quat(Eigen::AngleAxisd(kTilt, Vec3::UnitY())), Vec3(0, 0, 1 + kTilt));
  const auto patch = contact_patch(above, below, Vec3::UnitZ(), 0.02);
  ASSERT_EQ(patch.size(), 4u);
  for (const PatchPoint& point : patch) EXPECT_NEAR(point.distance, kTilt * (1 - point.on_b.x()), 1e-3);
}

TEST(ContactPatch, AnEdgeOnAFaceMeetsInALine) {
  const auto below = box_part(Vec3(3, 0.5, 1));
  const std::vector<Vec3> wedge = {Vec3(0, -1, 0.5), Vec3(0, 1, 0.5), Vec3(1, 0, 2), Vec3(-1, 0, 2)};
  const auto patch = contact_patch(wedge, below, Vec3::UnitZ(), 0.02);
  ASSERT_GE(patch.size(), 2u);
  for (const PatchPoint& point : patch) {
    EXPECT_NEAR(std::abs(point.on_b.y()), 0.25, 1e-9);
    EXPECT_NEAR(point.on_b.x(), 0, 1e-9);
    EXPECT_NEAR(point.distance, 0, 1e-9);
  }
}

TEST(ContactPatch, CornersAndCrossingEdgesHaveNone) {
  const auto below = box_part(Vec3(3, 3, 1));
  const std::vector<Vec3> spike = {Vec3(0, 0, 0.5), Vec3(1, 0, 2), Vec3(-1, 1, 2), Vec3(-1, -1, 2)};
  EXPECT_TRUE(contact_patch(spike, below, Vec3::UnitZ(), 0.02).empty());
  const std::vector<Vec3> roof = {Vec3(-1, 0, 0), Vec3(1, 0, 0), Vec3(0, 1, -1), Vec3(0, -1, -1)};
  const std::vector<Vec3> keel = {Vec3(0, -1, 0), Vec3(0, 1, 0), Vec3(1, 0, 1), Vec3(-1, 0, 1)};
  EXPECT_TRUE(contact_patch(keel, roof, Vec3::UnitZ(), 0.02).empty());
}

TEST(ContactPatch, PointsLieBetweenTheBodiesWhateverTheyAre) {
  std::mt19937 random(9);
  for (int trial = 0; trial < 500; ++trial) {
    const auto a = moved(testing::random_chunk(random, 1), Quat::Identity(), Vec3(0, 0, 1.8));
    const auto b = testing::random_chunk(random, 1);
    for (const PatchPoint& point : contact_patch(a, b, Vec3::UnitZ(), 0.3)) {
      EXPECT_LT(point.on_b.head<2>().norm(), 1.0);
      EXPECT_LT(std::abs(point.on_b.z()), 1.5);
      EXPECT_TRUE(std::isfinite(point.distance));
    }
  }
}

}  // namespace
}  // namespace griffith
