#include "sim/geometry/point_grid.h"

#include <gtest/gtest.h>

#include <limits>
#include <random>
#include <set>

namespace griffith {
namespace {

/// `count` points in a box of these sizes.
std::vector<Vec3> scattered(int count, const Vec3& sizes, unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> uniform(-0.5, 0.5);
  std::vector<Vec3> points;
  for (int i = 0; i < count; ++i)
    points.emplace_back(sizes.x() * uniform(random), sizes.y() * uniform(random), sizes.z() * uniform(random));
  return points;
}

TEST(PointGrid, VisitsEveryPointOfARegionOnce) {
  for (const Vec3& sizes : {Vec3(1, 1, 1), Vec3(100, 0.1, 1), Vec3(0, 5, 0), Vec3(0, 0, 0)})
    for (const double edge : {1e-6, 0.1, 1e3}) {
      const std::vector<Vec3> points = scattered(500, sizes, 1);
      const PointGrid grid(points, edge);
      for (const Vec3& center : scattered(20, 1.2 * sizes, 2)) {
        const Vec3 half = 0.1 * sizes + Vec3::Constant(1e-3);
        const Eigen::AlignedBox3d region(center - half, center + half);
        std::multiset<int> visited;
        grid.visit(region, [&](int point) { visited.insert(point); });
        for (int i = 0; i < 500; ++i) {
          EXPECT_LE(visited.count(i), 1u);
          if (region.contains(points[i])) {
            EXPECT_EQ(visited.count(i), 1u);
          }
        }
      }
    }
}

TEST(PointGrid, VisitsFewBesideARegion) {
  const std::vector<Vec3> points = scattered(8000, Vec3(1, 1, 1), 3);
  const PointGrid grid(points, 0.1);
  int visited = 0;
  grid.visit({Vec3::Constant(-0.05), Vec3::Constant(0.05)}, [&](int) { ++visited; });
  EXPECT_LE(visited, 27 * 12) << "8 points a box of the grid, 27 boxes at most";
}

TEST(PointGrid, TakesNothingAndWhatIsNotFinite) {
  int visited = 0;
  const auto count = [&](int) { ++visited; };
  PointGrid({}, 1).visit({Vec3::Constant(-1), Vec3::Constant(1)}, count);
  EXPECT_EQ(visited, 0);
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  std::vector<Vec3> points = scattered(10, Vec3(1, 1, 1), 4);
  points.emplace_back(kInfinity, 0, 0);
  points.emplace_back(0, std::numeric_limits<double>::quiet_NaN(), 0);
  PointGrid(points, 0.1).visit({Vec3::Constant(-kInfinity), Vec3::Constant(kInfinity)}, count);
  EXPECT_EQ(visited, 12);
}

}  // namespace
}  // namespace griffith
