#include <algorithm>
#include <cmath>
#include <limits>

#include "sim/core/error.h"
#include "sim/core/file_path.h"
#include "sim/mesh/read_mesh.h"
#include "sim/splinters/convex_cells.h"

namespace griffith {
namespace {

/// Returns the distance to the farthest corner of the box.
double farthest_distance(const Eigen::AlignedBox3d& box, const Vec3& point) {
  return (point - box.min()).cwiseAbs().cwiseMax((point - box.max()).cwiseAbs()).norm();
}

/// Returns a distance within which every place of the box has one of the points. Points farther than this from the box
/// do not matter.
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
  // Points far away or very close to others would exceed Voro++'s tolerance for the rest.
  std::erase_if(points, [&](const Vec3& point) { return !(bounds.exteriorDistance(point) <= radius); });
  const double step = kRounding * size;
  for (Vec3& point : points) point = step * (point / step).array().round();
  return voronoi_cells(std::move(points), bounds);
}

}  // namespace griffith
