#include "sim/scene/region.h"

#include <Eigen/Geometry>
#include <algorithm>

namespace griffith {
namespace {

struct Contains {
  const Vec3& point;
  int node;
  double tolerance;

  bool operator()(const BoxRegion& box) const {
    return (point.array() >= box.minimum.array() - tolerance).all() &&
           (point.array() <= box.maximum.array() + tolerance).all();
  }
  bool operator()(const SphereRegion& sphere) const {
    return (point - sphere.center).norm() <= sphere.radius + tolerance;
  }
  bool operator()(const HalfSpaceRegion& half_space) const {
    return (point - half_space.point).dot(half_space.normal.stableNormalized()) >= -tolerance;
  }
  bool operator()(const NodeListRegion& list) const { return std::ranges::find(list.nodes, node) != list.nodes.end(); }
};

}  // namespace

bool contains(const Region& region, const Vec3& point, int node, double tolerance) {
  return std::visit(Contains{point, node, tolerance}, region);
}

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
