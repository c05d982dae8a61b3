#include <algorithm>
#include <cmath>
#include <limits>

#include "sim/core/error.h"
#include "sim/core/file_path.h"
#include "sim/mesh/read_points.h"
#include "sim/splinters/convex_cells.h"

namespace griffith {
namespace {

/// The distance to the corner of the box that lies farthest away.
double farthest_distance(const Eigen::AlignedBox3d& box, const Vec3& point) {
  return (point - box.min()).cwiseAbs().cwiseMax((point - box.max()).cwiseAbs()).norm();
}

/// Distance of any place in the box within which lies one of the points, so those farther from all of the box have no
/// part in it.
double reach(const std::vector<Vec3>& points, const Eigen::AlignedBox3d& box) {
  double minimum = std::numeric_limits<double>::infinity();
  for (const Vec3& point : points) minimum = std::min(minimum, farthest_distance(box, point));
  return minimum;
}

}  // namespace

CellPartition make_point_cells(const PointSplinters& pattern, const Eigen::AlignedBox3d& bounds,
                               const std::filesystem::path& folder) {
  constexpr double kMaxSizes = 100;
  constexpr double kRounding = 1e-6;
  const std::filesystem::path path = file_path(folder, pattern.path);
  std::vector<Vec3> points = read_points(path);
  for (Vec3& point : points) point *= pattern.scale;
  const double size = bounds.diagonal().norm(), radius = reach(points, bounds);
  if (!(radius < kMaxSizes * size))
    throw InputError(path.string(), "has no point within a hundred times the body's size",
                     "the points are in the body's own frame; check their scale");
  // What lies far away or next to another point would put the rest beyond Voro++'s tolerance.
  std::erase_if(points, [&](const Vec3& point) { return !(bounds.exteriorDistance(point) <= radius); });
  const double step = kRounding * size;
  for (Vec3& point : points) point = step * (point / step).array().round();
  return voronoi_cells(std::move(points), bounds);
}

}  // namespace griffith
