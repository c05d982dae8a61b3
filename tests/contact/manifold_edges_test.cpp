// Pairs of hulls that edges part, or seem to.

#include <gtest/gtest.h>

#include <algorithm>

#include "sim/contact/manifold.h"
#include "sim/geometry/convex_hull.h"
#include "tests/contact/bodies.h"

namespace griffith {
namespace {

using namespace testing;
using contact::Hull;
using contact::Manifold;
using contact::Place;

Manifold found(const Hull& a, const Hull& b, const Place& a_in_b, double reach) {
  Manifold manifold;
  contact::find_contacts(manifold, {a, 0.3}, {b, 0.3}, a_in_b, reach);
  return manifold;
}

/// Half of a cube of 34 cm whose lower side bulges by half a millimeter: its edges there and those of a box beside it
/// lie in one plane. The normals at two of them lie on one great circle, along which rounding errors make them cross.
Hull bulging_cube() {
  return Hull(convex_hull(std::vector<Vec3>{{0.164, 0, 0},
                                            {-0.164, 0, 0},
                                            {0, 0, 0.164},
                                            {0, 0, -0.164},
                                            {0.17, 5e-4, 0.17},
                                            {-0.17, 5e-4, 0.17},
                                            {0.17, 5e-4, -0.17},
                                            {-0.17, 5e-4, -0.17},
                                            {0.15, 0.25, 0.15},
                                            {-0.15, 0.25, 0.15},
                                            {0.15, 0.25, -0.15},
                                            {-0.15, 0.25, -0.15}}));
}

TEST(ManifoldOfEdges, EdgesInOnePlanePartNothing) {
  const Hull plate(convex_hull(box_part(Vec3(0.4, 0.1, 0.4)))), cube = bulging_cube();
  for (unsigned seed = 0; seed < 200; ++seed) {
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> uniform(-1, 1);
    const double noise = std::pow(10, -18 + 6 * std::abs(uniform(random)));
    const Vec3 axis(uniform(random), uniform(random), uniform(random));
    const Place place{Eigen::AngleAxisd(noise, axis.normalized()).toRotationMatrix(), Vec3(0, -0.0497, 0)};
    const Manifold manifold = found(plate, cube, place, 0.01);
    ASSERT_GT(manifold.count, 0) << seed;
    EXPECT_NEAR(manifold.separation, -3e-4, 1e-9) << seed;
  }
}

/// Seen from above, planks of 4 cm that cross share an area whose diagonal is longer than they are wide. On one point
/// they would rock through one another.
TEST(ManifoldOfEdges, PlanksThatCrossTouchAllAroundTheAreaTheyShare) {
  const Hull plank(convex_hull(box_part(Vec3(0.6, 0.02, 0.04))));
  int at_edges = 0;
  for (unsigned seed = 0; seed < 200; ++seed) {
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> uniform(-1, 1);
    const double crossing = 1.2 + 0.3 * uniform(random), tilt = 0.04 * uniform(random);
    const Eigen::AngleAxisd turn(crossing, Vec3::UnitY()),
        lean(tilt, Vec3(uniform(random), 0, uniform(random)).normalized());
    const Place place{(lean * turn).toRotationMatrix(), Vec3(0.05 * uniform(random), 0.019, 0)};
    const Manifold manifold = found(plank, plank, place, 0.005);
    at_edges += manifold.feature == Manifold::Feature::edges;
    ASSERT_GE(manifold.count, 3) << seed;
    double widest = 0;
    for (const Manifold::Point& one : manifold.listed())
      for (const Manifold::Point& other : manifold.listed()) widest = std::max(widest, (one.on_b - other.on_b).norm());
    EXPECT_GT(widest, 0.04) << seed;
    for (const Manifold::Point& point : manifold.listed()) {
      EXPECT_NEAR(point.on_a.y(), -0.01, 1e-9) << "on the lower side, " << seed;
      EXPECT_NEAR(point.on_b.y(), 0.01, 1e-9) << "on the upper side, " << seed;
      const Vec3 apart = place.to_world(point.on_a) - point.on_b;
      EXPECT_LT((apart - apart.dot(manifold.normal_in_b) * manifold.normal_in_b).norm(), 1e-9) << seed;
    }
  }
  EXPECT_GT(at_edges, 50);
}

}  // namespace
}  // namespace griffith
