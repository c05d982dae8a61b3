#include "sim/meshing/smooth_normals.h"

#include <cmath>

namespace griffith {
namespace {

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
