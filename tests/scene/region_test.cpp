#include "sim/scene/region.h"

#include <gtest/gtest.h>

#include <random>

namespace griffith {
namespace {

constexpr double kTolerance = 1e-6;

TEST(Region, BoundariesBelongToItAndOneToleranceMoreDoesNot) {
  const Region box = BoxRegion{Vec3(-1, -2, -3), Vec3(1, 2, 3)};
  const Region sphere = SphereRegion{Vec3(1, 0, 0), 2};
  const Region half_space = HalfSpaceRegion{Vec3(0, 1, 0), Vec3(0, -5, 0)};
  for (const double beyond : {0.0, 0.5 * kTolerance}) {
    EXPECT_TRUE(contains(box, Vec3(1 + beyond, 2 + beyond, -3 - beyond), 0, kTolerance));
    EXPECT_TRUE(contains(sphere, Vec3(3 + beyond, 0, 0), 0, kTolerance));
    EXPECT_TRUE(contains(half_space, Vec3(9, 1 + beyond, 9), 0, kTolerance));
  }
  const double outside = 2 * kTolerance;
  EXPECT_FALSE(contains(box, Vec3(1 + outside, 0, 0), 0, kTolerance));
  EXPECT_FALSE(contains(box, Vec3(0, 0, -3 - outside), 0, kTolerance));
  EXPECT_FALSE(contains(sphere, Vec3(3 + outside, 0, 0), 0, kTolerance));
  EXPECT_FALSE(contains(half_space, Vec3(9, 1 + outside, 9), 0, kTolerance));
}

TEST(Region, AHalfSpaceDependsOnItsNormalsDirectionAlone) {
  std::mt19937 random(1);
  std::normal_distribution<double> normal;
  const auto vector = [&] { return Vec3(normal(random), normal(random), normal(random)); };
  for (int i = 0; i < 1000; ++i) {
    const Vec3 point = vector(), direction = vector(), place = vector();
    const bool inside = contains(HalfSpaceRegion{point, direction}, place, 0, 0);
    EXPECT_EQ(contains(HalfSpaceRegion{point, 1e-90 * direction}, place, 0, 0), inside);
    EXPECT_EQ(contains(HalfSpaceRegion{point, 1e90 * direction}, place, 0, 0), inside);
    EXPECT_NE(contains(HalfSpaceRegion{point, -direction}, place, 0, 0), inside);
  }
}

TEST(Region, NodesAreKnownByIndexWhereverTheyAre) {
  const Region list = NodeListRegion{{7, 2, 2}};
  for (int node = 0; node < 10; ++node) EXPECT_EQ(contains(list, Vec3::Zero(), node, 0), node == 7 || node == 2);
}

}  // namespace
}  // namespace griffith
