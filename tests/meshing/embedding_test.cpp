#include "sim/meshing/embedding.h"

#include <gtest/gtest.h>

#include <random>

#include "sim/mesh/box_mesh.h"
#include "sim/mesh/mesh_report.h"
#include "sim/meshing/mesh_surface.h"
#include "sim/meshing/tet_locator.h"
#include "surfaces.h"

namespace griffith {
namespace {

using namespace griffith::testing;

/// A ball's detailed surface in coarse tets: some of its points lie outside of them.
struct EmbeddedBall : ::testing::Test {
  EmbeddedBall() {
    MeshingOptions options;
    options.method = MeshingMethod::volumetric;
    options.element_size = 0.35;
    SurfaceMesh mesh = mesh_surface(sphere_surface(1, 16), options);
    surface = mesh.surface;
    soup = mesh.soup;
    embedding = embed(surface, soup);
    for (const auto& [a, b, c, d] : soup.tets) tets.push_back({NodeId(a), NodeId(b), NodeId(c), NodeId(d)});
    bodies.assign(tets.size(), BodyId(0));
  }

  std::array<Vec3, 3> corners(int triangle, std::span<const Vec3> positions) const {
    return embedded_corners(embedding, surface, triangle, {tets, bodies, positions, TetId(0)});
  }

  TriangleSurface surface;
  TetSoup soup;
  Embedding embedding;
  std::vector<std::array<NodeId, 4>> tets;
  std::vector<BodyId> bodies;
};

TEST_F(EmbeddedBall, AnAffineMotionOfTheTetsMovesTheSurfaceAlike) {
  const Mat3 stretch = Mat3::Identity() + 0.3 * Mat3::Random();
  const Vec3 shift(1, -2, 3);
  std::vector<Vec3> moved;
  for (const Vec3& point : soup.points) moved.push_back(stretch * point + shift);
  for (const bool parted : {false, true}) {
    for (std::size_t i = 0; i < bodies.size(); ++i) bodies[i] = BodyId(parted ? static_cast<std::int64_t>(i) : 0);
    for (int i = 0; i < static_cast<int>(surface.triangles.size()); ++i) {
      const auto rest = corners_of(surface, i), now = corners(i, moved);
      for (int corner = 0; corner < 3; ++corner)
        EXPECT_LT((now[corner] - (stretch * rest[corner] + shift)).norm(), 1e-9);
    }
  }
}

TEST_F(EmbeddedBall, WeightsAddUpToOneAndPointsInsideHaveNoneNegative) {
  for (std::size_t i = 0; i < surface.points.size(); ++i) {
    const EmbeddedPoint& point = embedding.points[i];
    EXPECT_NEAR(point.weights[0] + point.weights[1] + point.weights[2] + point.weights[3], 1, 1e-12);
  }
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

TEST_F(EmbeddedBall, NoTriangleSpansTwoBodies) {
  // The ball parts along the plane x = 0 and its halves move 10 m apart.
  std::vector<Vec3> moved = soup.points;
  for (std::size_t tet = 0; tet < tets.size(); ++tet) {
    Vec3 middle = Vec3::Zero();
    for (const NodeId node : tets[tet]) middle += soup.points[node] / 4;
    bodies[tet] = BodyId(middle.x() > 0 ? 1 : 0);
    for (NodeId& node : tets[tet]) {
      moved.push_back(soup.points[node] + Vec3(middle.x() > 0 ? 10 : 0, 0, 0));
      node = NodeId(static_cast<std::int64_t>(moved.size()) - 1);
    }
  }
  for (int i = 0; i < static_cast<int>(surface.triangles.size()); ++i) {
    const auto rest = corners_of(surface, i), now = corners(i, moved);
    EXPECT_NEAR(area_vector(now).norm(), area_vector(rest).norm(), 1e-9);
  }
}

TEST(SmoothNormals, OfABallPointOutwardsAndEdgesOfABoxStaySharp) {
  const TriangleSurface ball = sphere_surface(2, 16);
  const auto round = smooth_normals(ball);
  for (std::size_t i = 0; i < ball.triangles.size(); ++i)
    for (int corner = 0; corner < 3; ++corner) {
      const Vec3 outward = ball.points[ball.triangles[i][corner]].normalized();
      EXPECT_GT(round[i][corner].dot(outward), 0.999);
    }
  const TriangleSurface box = box_surface(Vec3::Zero(), Vec3::Ones());
  const auto sharp = smooth_normals(box);
  for (std::size_t i = 0; i < box.triangles.size(); ++i)
    for (const Vec3& normal : sharp[i])
      EXPECT_LT((normal - area_vector(corners_of(box, static_cast<int>(i))).normalized()).norm(), 1e-12);
}

}  // namespace
}  // namespace griffith
