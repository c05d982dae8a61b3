#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "sim/contact/contact_world.h"
#include "sim/geometry/convex_hull.h"
#include "tests/contact/bodies.h"
#include "tests/contact/lattice.h"

namespace griffith {
namespace {

using Body = testing::Lattice;

/// Returns how far a point lies outside of a hull [m].
double distance_outside(const ConvexHull& hull, const Vec3& point) {
  double farthest = 0;
  for (const std::vector<int>& face : hull.faces) {
    const Vec3 &a = hull.corners[face[0]], &b = hull.corners[face[1]], &c = hull.corners[face[2]];
    farthest = std::max(farthest, (b - a).cross(c - a).normalized().dot(point - a));
  }
  return farthest;
}

double total_hull_volume(const std::vector<ConvexPart>& parts) {
  double volume = 0;
  for (const ConvexPart& part : parts) volume += convex_hull(part).volume;
  return volume;
}

TEST(ConvexHull, MeasuresABoxWhateverItsPlace) {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> uniform(-1, 1);
  for (int trial = 0; trial < 20; ++trial) {
    const Vec3 size(1 + uniform(random) / 2, 0.2, 3);
    const Quat turn(Eigen::AngleAxisd(uniform(random), Vec3::Random().normalized()));
    std::vector<Vec3> points = testing::box_part(size);
    for (int i = 0; i < 50; ++i)
      points.push_back(0.49 * size.cwiseProduct(Vec3(uniform(random), uniform(random), uniform(random))));
    for (Vec3& point : points) point = turn * point + Vec3(5, -7, 2);
    const ConvexHull hull = convex_hull(points);
    EXPECT_EQ(hull.corners.size(), 8u);
    EXPECT_NEAR(hull.volume, size.prod(), 1e-9);
    const double area = 2 * (size.x() * size.y() + size.y() * size.z() + size.z() * size.x());
    EXPECT_NEAR(hull.area, area, 1e-9);
  }
}

TEST(ConvexHull, ShrinkingMovesEveryFaceInward) {
  const Vec3 size(1, 2, 0.5);
  const ConvexHull hull = convex_hull(testing::box_part(size));
  for (const Vec3& corner : shrunken_corners(hull, 0.01))
    EXPECT_LT((corner.cwiseAbs() - (size / 2 - Vec3::Constant(0.01))).norm(), 1e-8);
}

TEST(ConvexHull, FlatInputsAreSafe) {
  const std::vector<std::vector<Vec3>> flats = {
      {},
      {Vec3(1, 2, 3)},
      {Vec3::Zero(), Vec3::UnitX()},
      {Vec3::Zero(), Vec3::UnitX(), Vec3::UnitY()},
      {Vec3::Zero(), Vec3::UnitX(), Vec3::UnitY(), Vec3(1, 1, 0), Vec3(0.5, 0.5, 0)},
      {Vec3(1, 2, 3), Vec3(1, 2, 3), Vec3(1, 2, 3), Vec3(1, 2, 3)}};
  for (const auto& points : flats) {
    EXPECT_NEAR(convex_hull(points).volume, 0, 1e-12);
    if (points.empty()) continue;
    ContactWorld world(Vec3(0, -9.81, 0));
    world.add_ground(0, {});
    const ProxyId sliver = world.add_proxy(std::vector<ConvexPart>{points}, {}, Mobility::free, {}, {});
    testing::substep(world, {sliver}, 1e-3);
    EXPECT_TRUE(world.state(sliver).velocity.allFinite());
  }
}

TEST(ConvexParts, AConvexWallIsOnePart) {
  const Body body = testing::lattice(10, 7, [](int, int) { return false; });
  const auto parts = convex_parts(body.points, body.points, body.tets);
  ASSERT_EQ(parts.size(), 1u);
  EXPECT_EQ(parts[0].size(), 8u);
  EXPECT_NEAR(total_hull_volume(parts), 70, 1e-9);
}

TEST(ConvexParts, PartsFillTheirHullsAndLeaveHolesOpen) {
  const auto hole = [](int i, int j) { return i >= 3 && i < 7 && j >= 2 && j < 6; };
  const Body body = testing::lattice(10, 8, hole);
  const auto parts = convex_parts(body.points, body.points, body.tets, 0.9);
  EXPECT_GT(parts.size(), 1u);
  EXPECT_LE(parts.size(), 24u);
  const double volume = static_cast<double>(body.tets.size()) / 6;
  EXPECT_GE(total_hull_volume(parts), volume - 1e-9);
  EXPECT_LE(total_hull_volume(parts), 1.15 * volume);
}

/// Contacts would find bodies deep inside of parts that were none before.
TEST(ConvexParts, ADeformedBodyIsDividedAsAtRest) {
  const Body body = testing::lattice(10, 8, [](int i, int j) { return i >= 3 && i < 7 && j >= 2 && j < 6; });
  const auto bend = [](const Vec3& p) { return Vec3(p.x(), p.y() - 0.03 * p.x() * p.x(), p.z()); };
  const auto unbent = [](const Vec3& p) { return Vec3(p.x(), p.y() + 0.03 * p.x() * p.x(), p.z()); };
  Body bent = body;
  std::ranges::transform(body.points, bent.points.begin(), bend);
  const auto parts = convex_parts(body.points, body.points, body.tets),
             deformed = convex_parts(bent.points, body.points, body.tets);
  ASSERT_EQ(deformed.size(), parts.size());
  for (std::size_t i = 0; i < parts.size(); ++i) {
    const ConvexHull hull = convex_hull(parts[i]);
    for (const Vec3& p : deformed[i]) EXPECT_LT(distance_outside(hull, unbent(p)), 1e-9);
  }
}

TEST(ConvexParts, OneTetIsExact) {
  const Body body = {{Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(0, 2, 0), Vec3(0.3, 0.2, 3)}, {{0, 1, 2, 3}}};
  EXPECT_EQ(convex_parts(body.points, body.points, body.tets), std::vector<ConvexPart>{body.points});
}

TEST(ConvexParts, ASmallPieceIsItsPartsExactly) {
  const Body body = testing::lattice(3, 3, [](int i, int j) { return i > 0 && j > 0; });
  const auto parts = convex_parts(body.points, body.points, body.tets);
  EXPECT_EQ(parts.size(), 2u);
  EXPECT_NEAR(total_hull_volume(parts), static_cast<double>(body.tets.size()) / 6, 1e-9);
}

TEST(ConvexParts, RoundBodiesKeepFewCorners) {
  Body body{{Vec3::Zero()}, {}};
  std::mt19937 random(5);
  std::normal_distribution<double> normal;
  for (int i = 0; i < 300; ++i)
    body.points.push_back(Vec3(normal(random), normal(random), normal(random)).normalized());
  const ConvexHull hull = convex_hull(body.points);
  for (const auto& face : hull.faces)
    for (std::size_t k = 2; k < face.size(); ++k) {
      const auto index = [&](int corner) {
        return static_cast<int>(std::find(body.points.begin(), body.points.end(), hull.corners[corner]) -
                                body.points.begin());
      };
      body.tets.push_back({0, index(face[0]), index(face[k - 1]), index(face[k])});
    }
  const auto parts = convex_parts(body.points, body.points, body.tets);
  ASSERT_EQ(parts.size(), 1u);
  EXPECT_LE(parts[0].size(), 42u);
  EXPECT_GT(total_hull_volume(parts), 0.8 * hull.volume);
}

TEST(ConvexParts, NoTetsNoParts) { EXPECT_TRUE(convex_parts({}, {}, {}).empty()); }

}  // namespace
}  // namespace griffith
