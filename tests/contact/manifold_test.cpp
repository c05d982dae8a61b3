#include "sim/contact/manifold.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "sim/geometry/convex_hull.h"
#include "tests/contact/bodies.h"

namespace griffith {
namespace {

using namespace testing;
using contact::Hull;
using contact::Manifold;
using contact::Place;

/// Returns the largest distance of a point from the planes of a hull, outward; negative inside.
double height_over(const Hull& hull, const Vec3& point) {
  double height = -std::numeric_limits<double>::infinity();
  for (const Hull::Face& face : hull.faces) height = std::max(height, face.normal.dot(point) - face.offset);
  return height;
}

/// By how much a direction parts two hulls, b in its frame and a at a place in it.
double gap_along(const Hull& a, const Hull& b, const Place& place, const Vec3& direction) {
  double lowest = std::numeric_limits<double>::infinity(), highest = -lowest;
  for (const Vec3& corner : a.corners) lowest = std::min(lowest, direction.dot(place.to_world(corner)));
  for (const Vec3& corner : b.corners) highest = std::max(highest, direction.dot(corner));
  return lowest - highest;
}

struct RandomPair {
  explicit RandomPair(unsigned seed) : random(seed), a(convex_hull(part(seed))), b(convex_hull(part(seed / 2))) {}
  ConvexPart part(unsigned choice) { return choice % 2 == 0 ? box_part(Vec3(0.4, 0.7, 1)) : random_chunk(random, 0.5); }
  Vec3 direction() {
    std::normal_distribution<double> normal;
    return Vec3(normal(random), normal(random), normal(random)).normalized();
  }
  Place place() {
    std::uniform_real_distribution<double> uniform(0, 1);
    return {Eigen::AngleAxisd(3 * uniform(random), direction()).toRotationMatrix(),
            1.1 * uniform(random) * direction()};
  }
  Manifold found(const Place& place, double reach) const {
    Manifold manifold;
    contact::find_contacts(manifold, {a, 0.7}, {b, 0.7}, place, reach);
    return manifold;
  }

  std::mt19937 random;
  Hull a, b;
};

TEST(Hull, ABoxHasSixSidesHoweverItIsRoundedOrSlightlyBent) {
  for (const double bend : {0.0, 1e-12, 1e-6, 1e-4})
    for (unsigned seed = 0; seed < 20; ++seed) {
      std::mt19937 random(seed);
      std::uniform_real_distribution<double> uniform(-1, 1);
      ConvexPart corners = box_part(Vec3(0.12, 0.08, 0.1));
      const Quat turn = Quat(uniform(random), uniform(random), uniform(random), uniform(random)).normalized();
      for (Vec3& corner : corners)
        corner = turn * corner + 0.1 * bend * Vec3(uniform(random), uniform(random), uniform(random));
      const Hull hull(convex_hull(corners));
      EXPECT_EQ(hull.faces.size(), 6u) << bend << ' ' << seed;
      EXPECT_EQ(hull.edges.size(), 12u) << bend << ' ' << seed;
      for (const Vec3& corner : corners) EXPECT_LT(height_over(hull, corner), 1e-15);
    }
}

// A node on an edge of a broken piece lies in it but for what the piece was deformed: between it and the edge is a
// triangle that looks anywhere. As a face it would part what overlaps, and hide how deep.
TEST(Hull, ABoxHasSixSidesHoweverManyNodesLieOnItsEdges) {
  const double size = Vec3(0.4, 0.7, 1).norm();
  for (unsigned seed = 0; seed < 500; ++seed) {
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> uniform(-1, 1);
    ConvexPart corners = box_part(Vec3(0.4, 0.7, 1));
    for (int i = 0; i < 6; ++i) {
      const Vec3 &from = corners[random() % 8], &to = corners[random() % 8];
      corners.push_back(from + 0.5 * (1 + uniform(random)) * (to - from));
    }
    const double uneven = std::pow(10, -7 + (1 + uniform(random)));  // up to 1e-5
    for (Vec3& corner : corners) corner += uneven * size * Vec3(uniform(random), uniform(random), uniform(random));
    const Hull hull(convex_hull(corners));
    ASSERT_EQ(hull.faces.size(), 6u) << seed;
    for (const Vec3& corner : hull.corners) EXPECT_LT(height_over(hull, corner), 1e-12) << seed;
    EXPECT_GT(hull.inner_radius, 0.1) << seed;
  }
}

TEST(Manifold, NoDirectionPartsOverlappingHullsBetterThanItsNormal) {
  constexpr double kReach = 0.02, kForFaces = 2e-3 * 0.7;  // so much a face may be worse than two edges
  int overlapping = 0;
  for (unsigned seed = 0; seed < 100; ++seed) {
    RandomPair pair(seed);
    const Place place = pair.place();
    const Manifold manifold = pair.found(place, kReach);
    const double best = manifold.separation;
    for (int i = 0; i < 300 && best <= 0; ++i)
      ASSERT_LE(gap_along(pair.a, pair.b, place, pair.direction()), best + kForFaces + 1e-9) << seed;
    if (manifold.count == 0) continue;
    EXPECT_NEAR(gap_along(pair.a, pair.b, place, manifold.normal_in_b), best, 1e-9) << seed;
    overlapping += best < 0;
  }
  EXPECT_GT(overlapping, 30);
}

TEST(Manifold, ItsPointsLieOnBothSurfaces) {
  constexpr double kReach = 0.02;
  int touching = 0;
  for (unsigned seed = 0; seed < 300; ++seed) {
    RandomPair pair(seed);
    const Place place = pair.place();
    const Manifold manifold = pair.found(place, kReach);
    touching += manifold.count > 0;
    for (const Manifold::Point& point : manifold.listed()) {
      const Vec3 apart = place.to_world(point.on_a) - point.on_b;
      EXPECT_LT((apart - apart.dot(manifold.normal_in_b) * manifold.normal_in_b).norm(), 1e-9) << seed;
      EXPECT_LT(apart.dot(manifold.normal_in_b), kReach);
      EXPECT_LT(height_over(pair.a, point.on_a), std::max(1e-9, apart.norm())) << seed;
      EXPECT_LT(height_over(pair.b, point.on_b), std::max(1e-9, apart.norm())) << seed;
    }
  }
  EXPECT_GT(touching, 60);
}

TEST(Manifold, FollowedStepByStepItIsAsFoundAtOnce) {
  constexpr double kReach = 0.014;
  for (unsigned seed = 0; seed < 40; ++seed) {
    RandomPair pair(seed);
    Place place = pair.place();
    Manifold followed;
    const Vec3 way = -0.004 * place.translation.normalized();
    const Mat3 turn = Eigen::AngleAxisd(0.01, pair.direction()).toRotationMatrix();
    for (int step = 0; step < 100; ++step) {
      place = {turn * place.rotation, place.translation + way};
      contact::find_contacts(followed, {pair.a, 0.7}, {pair.b, 0.7}, place, kReach);
      const Manifold fresh = pair.found(place, kReach);
      ASSERT_EQ(followed.count > 0, fresh.count > 0 || followed.separation <= kReach) << seed << ' ' << step;
      if (followed.count == 0 || fresh.count == 0) continue;
      // What was kept may be worse by no more than what it is kept for.
      EXPECT_NEAR(gap_along(pair.a, pair.b, place, followed.normal_in_b),
                  gap_along(pair.a, pair.b, place, fresh.normal_in_b), kReach)
          << seed << ' ' << step;
    }
  }
}

/// Two polyhedra of few corners, as cracks leave them, flat or thin.
struct SliverPair : RandomPair {
  explicit SliverPair(unsigned seed) : RandomPair(seed) {
    a = Hull(convex_hull(sliver()));
    b = Hull(convex_hull(sliver()));
  }
  ConvexPart sliver() {
    std::uniform_real_distribution<double> uniform(0.05, 1);
    const Vec3 size(0.5, 0.5 * uniform(random), 0.5 * uniform(random));
    ConvexPart corners(uniform(random) < 0.5 ? 4 : 6);
    for (Vec3& corner : corners) corner = size.cwiseProduct(direction());
    return corners;
  }
};

// The face that is met need not look most against the one that it meets: that may be a face on the other side of a tip.
TEST(Manifold, SplintersThatOverlapHavePointsAsDeepAsTheyOverlap) {
  constexpr double kForFaces = 2e-3 * 0.7;  // so much a face may be worse than two edges
  int overlapping = 0;
  for (unsigned seed = 0; seed < 5000; ++seed) {
    SliverPair pair(seed);
    if (!pair.a.is_solid() || !pair.b.is_solid()) continue;
    Place place = pair.place();
    place.translation *= 0.8;
    const Manifold manifold = pair.found(place, 0.01);
    if (!(manifold.separation < -0.01)) continue;
    ++overlapping;
    ASSERT_GT(manifold.count, 0) << seed;
    double deepest = 0;
    for (const Manifold::Point& point : manifold.listed())
      deepest = std::min(deepest, manifold.normal_in_b.dot(place.to_world(point.on_a) - point.on_b));
    EXPECT_NEAR(deepest, manifold.separation, kForFaces) << seed;
  }
  EXPECT_GT(overlapping, 200);
}

// The axis across two edges that do not face each other any more parts nothing, and may look the other way.
TEST(Manifold, SplintersFollowedStepByStepOverlapAsMuchAsFoundAtOnce) {
  int overlapping = 0;
  for (unsigned seed = 0; seed < 2000; ++seed) {
    SliverPair pair(seed);
    if (!pair.a.is_solid() || !pair.b.is_solid()) continue;
    Place place = pair.place();
    Manifold followed;
    const Vec3 way = -0.004 * place.translation.normalized();
    const Mat3 turn = Eigen::AngleAxisd(0.02, pair.direction()).toRotationMatrix();
    for (int step = 0; step < 100; ++step) {
      place = {turn * place.rotation, place.translation + way};
      contact::find_contacts(followed, {pair.a, 0.7}, {pair.b, 0.7}, place, 0.01);
      const Manifold fresh = pair.found(place, 0.01);
      if (!(fresh.separation < 0)) continue;
      ++overlapping;
      ASSERT_GT(followed.count, 0) << seed << ' ' << step;
      ASSERT_NEAR(followed.separation, fresh.separation, 0.003) << seed << ' ' << step;
    }
  }
  EXPECT_GT(overlapping, 2000);
}

}  // namespace
}  // namespace griffith
