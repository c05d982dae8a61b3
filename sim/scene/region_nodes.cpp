#include "sim/scene/region_nodes.h"

#include <Eigen/Geometry>

namespace griffith {

std::vector<std::uint8_t> nodes_in(const Region& region, std::span<const Vec3> points, std::span<const int> numbers) {
  constexpr double kTolerance = 1e-9;  // relative to the body's size
  Eigen::AlignedBox3d bounds;
  for (const Vec3& point : points) bounds.extend(point);
  const double tolerance = kTolerance * bounds.diagonal().norm();
  std::vector<std::uint8_t> inside(points.size(), 0);
  for (std::size_t node = 0; node < inside.size(); ++node)
    inside[node] = contains(region, points[node], numbers[node], tolerance);
  return inside;
}

}  // namespace griffith
