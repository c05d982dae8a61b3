#include "sim/meshing/surface.h"

#include <algorithm>

#include "sim/core/sort_unique.h"

namespace griffith {
namespace {

/// Returns, per point of a triangle, the first one with the same coordinates.
std::vector<int> first_equal_points(const TriangleSurface& surface) {
  const std::vector<Vec3>& points = surface.points;
  std::vector<int> order;
  for (const auto& triangle : surface.triangles) order.insert(order.end(), triangle.begin(), triangle.end());
  sort_unique(order);
  const auto key = [&](int i) { return std::tuple(points[i].x(), points[i].y(), points[i].z()); };
  std::sort(order.begin(), order.end(), [&](int a, int b) { return std::pair(key(a), a) < std::pair(key(b), b); });
  std::vector<int> first(points.size());
  for (std::size_t i = 0; i < order.size(); ++i) {
    const bool repeated = i > 0 && points[order[i]] == points[order[i - 1]];
    first[order[i]] = repeated ? first[order[i - 1]] : order[i];
  }
  return first;
}

}  // namespace

void weld_points(TriangleSurface& surface) {
  const std::vector<int> first = first_equal_points(surface);
  std::vector<int> renumbered(surface.points.size(), -1);
  for (auto& triangle : surface.triangles)
    for (int& corner : triangle) renumbered[corner = first[corner]] = 0;
  int count = 0;
  for (std::size_t i = 0; i < renumbered.size(); ++i) {
    if (renumbered[i] < 0) continue;
    surface.points[count] = surface.points[i];
    renumbered[i] = count++;
  }
  surface.points.resize(count);
  for (auto& triangle : surface.triangles)
    for (int& corner : triangle) corner = renumbered[corner];
}

Eigen::AlignedBox3d bounds(const TriangleSurface& surface) {
  Eigen::AlignedBox3d box;
  for (const Vec3& point : surface.points) box.extend(point);
  return box;
}

double enclosed_volume(const TriangleSurface& surface) {
  if (surface.points.empty()) return 0;
  const Vec3 origin = surface.points.front();  // near the surface, to reduce rounding errors
  double volume = 0;
  for (std::size_t i = 0; i < surface.triangles.size(); ++i) {
    const auto corners = corners_of(surface, static_cast<int>(i));
    volume += area_vector(corners).dot(corners[0] - origin) / 3;
  }
  return volume;
}

double surface_area(const TriangleSurface& surface) {
  double area = 0;
  for (std::size_t i = 0; i < surface.triangles.size(); ++i)
    area += area_vector(corners_of(surface, static_cast<int>(i))).norm();
  return area;
}

}  // namespace griffith
