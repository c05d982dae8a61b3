#include "sim/meshing/embedding.h"

#include <algorithm>
#include <cmath>

#include "sim/core/parallel.h"
#include "sim/meshing/tet_locator.h"

namespace griffith {
namespace {

Vec3 carried(const CarryingTets& carrying, int tet, const std::array<double, 4>& weights) {
  const auto& nodes = carrying.tets[carrying.first_tet.index() + tet];
  Vec3 sum = Vec3::Zero();
  for (int corner = 0; corner < 4; ++corner) sum += weights[corner] * carrying.positions[nodes[corner]];
  return sum;
}

double angle_at(const std::array<Vec3, 3>& corners, int corner) {
  const Vec3 a = corners[(corner + 1) % 3] - corners[corner], b = corners[(corner + 2) % 3] - corners[corner];
  return std::atan2(a.cross(b).norm(), a.dot(b));
}

/// Returns the corners (counted over all triangles) at each point.
std::vector<std::vector<int>> corners_by_point(const TriangleSurface& surface) {
  std::vector<std::vector<int>> corners(surface.points.size());
  for (std::size_t i = 0; i < surface.triangles.size(); ++i)
    for (int corner = 0; corner < 3; ++corner)
      corners[surface.triangles[i][corner]].push_back(3 * static_cast<int>(i) + corner);
  return corners;
}

}  // namespace

Embedding embed(const TriangleSurface& surface, const TetSoup& soup) {
  const TetLocator locator(soup);
  Embedding embedding;
  embedding.points.resize(surface.points.size());
  embedding.triangles.resize(surface.triangles.size());
  parallel_for(static_cast<int>(surface.points.size()), 64, [&](int begin, int end) {
    for (int i = begin; i < end; ++i) embedding.points[i] = locator.locate(surface.points[i]);
  });
  parallel_for(static_cast<int>(surface.triangles.size()), 64, [&](int begin, int end) {
    for (int i = begin; i < end; ++i) {
      const auto corners = corners_of(surface, i);
      EmbeddedTriangle& triangle = embedding.triangles[i];
      triangle.tet = locator.locate((corners[0] + corners[1] + corners[2]) / 3).tet;
      for (int corner = 0; corner < 3; ++corner)
        triangle.weights[corner] = locator.weights_in(triangle.tet, corners[corner]);
    }
  });
  return embedding;
}

std::array<Vec3, 3> embedded_corners(const Embedding& embedding, const TriangleSurface& surface, int triangle,
                                     const CarryingTets& carrying) {
  const auto body_of = [&](int tet) { return carrying.bodies[carrying.first_tet.index() + tet]; };
  const EmbeddedTriangle& whole = embedding.triangles[triangle];
  const auto& points = surface.triangles[triangle];
  const bool together = std::all_of(points.begin(), points.end(), [&](int point) {
    return body_of(embedding.points[point].tet) == body_of(whole.tet);
  });
  std::array<Vec3, 3> corners;
  for (int corner = 0; corner < 3; ++corner) {
    const EmbeddedPoint& point = embedding.points[points[corner]];
    corners[corner] =
        together ? carried(carrying, point.tet, point.weights) : carried(carrying, whole.tet, whole.weights[corner]);
  }
  return corners;
}

std::vector<std::array<Vec3, 3>> smooth_normals(const TriangleSurface& surface, double crease) {
  const auto corners_at = corners_by_point(surface);
  std::vector<Vec3> normals;
  for (std::size_t i = 0; i < surface.triangles.size(); ++i)
    normals.push_back(area_vector(corners_of(surface, static_cast<int>(i))).normalized());
  const double maximum = std::cos(crease);
  std::vector<std::array<Vec3, 3>> result(surface.triangles.size());
  for (std::size_t i = 0; i < surface.triangles.size(); ++i)
    for (int corner = 0; corner < 3; ++corner) {
      Vec3& sum = result[i][corner] = surface.normals.empty() ? Vec3(Vec3::Zero()) : surface.normals[i][corner];
      if (!sum.isZero(0)) continue;
      for (const int other : corners_at[surface.triangles[i][corner]])
        if (normals[i].dot(normals[other / 3]) >= maximum)
          sum += angle_at(corners_of(surface, other / 3), other % 3) * normals[other / 3];
      sum.normalize();
    }
  return result;
}

}  // namespace griffith
