#include "sim/splinters/convex_cells.h"

#include <algorithm>
#include <limits>

#include "sim/core/error.h"
#include "sim/core/file_path.h"

namespace griffith {
namespace {

struct Maker {
  const Eigen::AlignedBox3d& bounds;
  const std::filesystem::path& folder;

  CellPartition operator()(const VoronoiSplinters& pattern) const { return make_voronoi_cells(pattern, bounds); }
  CellPartition operator()(const RadialSplinters& pattern) const { return make_radial_cells(pattern, bounds); }
  CellPartition operator()(const BrickSplinters& pattern) const { return make_brick_cells(pattern, bounds); }
  CellPartition operator()(const PointSplinters& pattern) const { return make_point_cells(pattern, bounds, folder); }
  CellPartition operator()(const CellSplinters& pattern) const {
    return read_cells(file_path(folder, pattern.path), pattern.scale);
  }
};

/// Returns the wall that a point is farthest outside; null if it is outside none.
const CellWall* worst_wall(const ConvexCell& cell, const Vec3& point) {
  const CellWall* worst = nullptr;
  double farthest = 0;
  for (const CellWall& wall : cell.walls) {
    if (wall.inside.distance(point) <= farthest) continue;
    farthest = wall.inside.distance(point);
    worst = &wall;
  }
  return worst;
}

int nearest_cell(const CellPartition& cells, const Vec3& point) {
  int best = 0;
  double minimum = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < cells.size(); ++i) {
    const CellWall* wall = worst_wall(cells[i], point);
    const double outside = wall ? wall->inside.distance(point) : 0;
    if (outside < minimum) minimum = outside, best = static_cast<int>(i);
  }
  return best;
}

}  // namespace

CellPartition make_cells(const SplinterPattern& pattern, const Eigen::AlignedBox3d& bounds,
                         const std::filesystem::path& folder, const std::string& where) try {
  return std::visit(Maker{bounds, folder}, pattern);
} catch (const TooManyCells&) {
  throw InputError(where, "would make more than 2 million splinters", "use larger ones");
}

void check_cell_count(double cells) {
  if (cells > kMaxSplinterCells) throw TooManyCells();
}

int locate(const CellPartition& cells, const Vec3& point, int start) {
  int cell = start;
  for (std::size_t steps = 0; steps < cells.size(); ++steps) {
    const CellWall* wall = worst_wall(cells[cell], point);
    if (!wall) return cell;
    if (wall->neighbor < 0) break;
    cell = wall->neighbor;
  }
  return nearest_cell(cells, point);  // rounding led the walk in circles
}

}  // namespace griffith
