#include "sim/meshing/smooth_normals.h"

#include <gtest/gtest.h>

#include "surfaces.h"

namespace griffith {
namespace {

using namespace griffith::testing;

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
