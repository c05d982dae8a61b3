#include "sim/contact/convex_clusters.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>
#include <random>

#include "sim/geometry/convex_hull.h"
#include "tests/contact/lattice.h"

namespace griffith {
namespace {

using testing::Lattice;

constexpr double kExact = 1e-9;

/// Volumes of some tets and of their hull [m³].
struct Volumes {
  double tets = 0, hull = 0;
};

Volumes volumes_of(const Lattice& body, const std::vector<int>& cluster) {
  Volumes volumes;
  std::vector<Vec3> corners;
  for (const int index : cluster) {
    std::vector<Vec3> of_tet;
    for (const int corner : body.tets[index]) of_tet.push_back(body.points[corner]);
    volumes.tets += convex_hull(of_tet).volume;
    corners.insert(corners.end(), of_tet.begin(), of_tet.end());
  }
  volumes.hull = convex_hull(corners).volume;
  return volumes;
}

/// Returns a lattice with bent planes, of which random tets are missing.
Lattice random_piece(std::mt19937& random) {
  Lattice body = testing::lattice(2, 2, [](int, int) { return false; });
  std::uniform_real_distribution<double> shift(-0.1, 0.1);
  for (Vec3& point : body.points) point += Vec3(shift(random), shift(random), shift(random));
  std::ranges::shuffle(body.tets, random);
  body.tets.resize(2 + random() % (body.tets.size() - 2));
  return body;
}

TEST(ConvexClusters, AConvexBodyIsOneCluster) {
  const Lattice body = testing::lattice(3, 2, [](int, int) { return false; });
  EXPECT_EQ(convex_clusters(body.points, body.tets, kExact).size(), 1u);
}

TEST(ConvexClusters, AnAngleIsTwoClusters) {
  const Lattice body = testing::lattice(3, 3, [](int i, int j) { return i > 0 && j > 0; });
  const auto clusters = convex_clusters(body.points, body.tets, kExact);
  ASSERT_EQ(clusters.size(), 2u);
  for (const std::vector<int>& cluster : clusters)
    EXPECT_NEAR(volumes_of(body, cluster).hull, volumes_of(body, cluster).tets, kExact);
  EXPECT_EQ(convex_clusters(body.points, body.tets, 3).size(), 1u);
}

TEST(ConvexClusters, EveryTetIsInOneClusterThatIsItsHull) {
  std::mt19937 random(7);
  for (int trial = 0; trial < 100; ++trial) {
    const Lattice body = random_piece(random);
    const auto clusters = convex_clusters(body.points, body.tets, kExact);
    std::vector<int> all;
    for (const std::vector<int>& cluster : clusters) {
      all.insert(all.end(), cluster.begin(), cluster.end());
      const Volumes volumes = volumes_of(body, cluster);
      EXPECT_NEAR(volumes.hull, volumes.tets, 1e-6 * volumes.hull);
    }
    std::ranges::sort(all);
    std::vector<int> expected(body.tets.size());
    std::iota(expected.begin(), expected.end(), 0);
    EXPECT_EQ(all, expected);
  }
}

TEST(ConvexClusters, TetsThatShareNoFaceStayApart) {
  const Lattice body = {{Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(0, 1, 0), Vec3(0, 0, 1), Vec3(0, 0, -1), Vec3(0, -1, 0)},
                        {{0, 1, 2, 3}, {0, 1, 4, 5}}};
  EXPECT_EQ(convex_clusters(body.points, body.tets, kExact).size(), 2u);
}

}  // namespace
}  // namespace griffith
