#include "sim/meshing/tet_locator.h"

#include <gtest/gtest.h>

#include <random>

#include "sim/mesh/mesh_report.h"
#include "sim/meshing/mesh_surface.h"
#include "surfaces.h"

namespace griffith {
namespace {

using namespace griffith::testing;

/// A ball's detailed surface and coarse tets: some of its points lie outside of them.
struct LocatorInBall : ::testing::Test {
  LocatorInBall() {
    MeshingOptions options;
    options.method = MeshingMethod::volumetric;
    options.element_size = 0.35;
    mesh = mesh_surface(sphere_surface(1, 16), options);
  }
  SurfaceMesh mesh;
};

TEST_F(LocatorInBall, AnAffineMotionOfTheTetsMovesPointsAlike) {
  const Mat3 stretch = Mat3::Identity() + 0.3 * Mat3::Random();
  const TetLocator locator(mesh.soup);
  for (const Vec3& point : mesh.surface.points) {
    const EmbeddedPoint embedded = locator.locate(point);
    Vec3 moved = Vec3::Zero();
    double sum = 0;
    for (int corner = 0; corner < 4; ++corner) {
      moved += embedded.weights[corner] * (stretch * mesh.soup.points[mesh.soup.tets[embedded.tet][corner]]);
      sum += embedded.weights[corner];
    }
    EXPECT_LT((moved - stretch * point).norm(), 1e-9);
    EXPECT_NEAR(sum, 1, 1e-12);
  }
}

TEST_F(LocatorInBall, PointsInsideHaveNoNegativeWeights) {
  const TetSoup& soup = mesh.soup;
  const TetLocator locator(soup);
  std::mt19937 random(2);
  std::uniform_real_distribution<double> uniform(0, 1);
  for (int sample = 0; sample < 300; ++sample) {
    const auto& tet = soup.tets[random() % soup.tets.size()];
    Vec3 point = Vec3::Zero();
    double sum = 0;
    for (const int corner : tet) {
      const double weight = uniform(random);
      point += weight * soup.points[corner];
      sum += weight;
    }
    for (const double weight : locator.locate(point / sum).weights) EXPECT_GE(weight, -1e-9);
  }
}

}  // namespace
}  // namespace griffith
