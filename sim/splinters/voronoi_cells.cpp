#include <algorithm>
#include <array>
#include <cmath>
#include <voro++/voro++.hh>

#include "sim/splinters/convex_cells.h"
#include "sim/splinters/random_unit.h"

namespace griffith {
namespace {

/// Returns a rotation of the grain to z with a compression along it.
Mat3 compression(const Vec3& any_grain, double elongation) {
  const Vec3 grain = any_grain.normalized(), across = grain.unitOrthogonal();
  Mat3 rows;
  rows << across.transpose(), grain.cross(across).transpose(), grain.transpose() / elongation;
  return rows;
}

/// Returns cells of compressed space in rest space.
CellPartition decompressed(CellPartition cells, const Mat3& compression) {
  for (ConvexCell& cell : cells)
    for (CellWall& wall : cell.walls) {
      const Vec3 normal = compression.transpose() * wall.inside.normal;
      wall.inside = {normal.normalized(), wall.inside.offset / normal.norm()};
    }
  return cells;
}

Eigen::AlignedBox3d transformed(const Mat3& map, const Eigen::AlignedBox3d& box) {
  const Vec3 center = map * box.center(), half = map.cwiseAbs() * box.sizes() / 2;
  return {Vec3(center - half), Vec3(center + half)};
}

/// Returns a point in each cell of a lattice that extends two cells beyond the bounds, so that cells within them equal
/// those of an infinite lattice.
std::vector<Vec3> jittered_lattice(const VoronoiSplinters& pattern, const Eigen::AlignedBox3d& bounds) {
  constexpr double kMargin = 2;
  const Vec3 low = (bounds.min() / pattern.size).array().floor() - kMargin;
  const Vec3 high = (bounds.max() / pattern.size).array().floor() + kMargin;
  check_cell_count((high - low).array().max(1).prod());
  std::vector<Vec3> points;
  for (double z = low.z(); z <= high.z(); ++z)
    for (double y = low.y(); y <= high.y(); ++y)
      for (double x = low.x(); x <= high.x(); ++x) {
        Vec3 point(x, y, z);
        for (int i = 0; i < 3; ++i)
          point[i] +=
              0.5 + pattern.jitter * (random_unit(pattern.seed, static_cast<std::int64_t>(x),
                                                  static_cast<std::int64_t>(y), static_cast<std::int64_t>(z), i) -
                                      0.5);
        points.push_back(pattern.size * point);
      }
  return points;
}

/// Returns a point of a tet between its center and a uniformly random place.
Vec3 place_in(const TetMesh& mesh, TetId tet, const ShardPattern& pattern) {
  std::array<double, 4> weights;
  double sum = 0;
  for (int i = 0; i < 4; ++i) sum += weights[i] = -std::log1p(-random_unit(pattern.seed, tet.index(), i));
  Vec3 place = Vec3::Zero();
  for (int i = 0; i < 4; ++i)
    place += std::lerp(0.25, weights[i] / sum, pattern.jitter) * mesh.rest_positions[mesh.tets[tet][i]];
  return place;
}

/// Returns, per point, the points with adjacent Voronoi cells, found by Voro++ (Rycroft 2009), whose tolerance suits
/// points about one apart.
std::vector<std::vector<int>> voronoi_neighbors(const std::vector<Vec3>& points, const Eigen::AlignedBox3d& box) {
  constexpr double kPointsPerBlock = 5;
  constexpr int kBlockMemory = 8;
  const double spacing = std::cbrt(box.volume() / static_cast<double>(points.size()));
  const Vec3 low = box.min() / spacing, high = box.max() / spacing;
  std::array<int, 3> blocks;
  for (int i = 0; i < 3; ++i)
    blocks[i] = std::clamp(static_cast<int>((high - low)[i] / std::cbrt(kPointsPerBlock)), 1, 1000);
  voro::container container(low.x(), high.x(), low.y(), high.y(), low.z(), high.z(), blocks[0], blocks[1], blocks[2],
                            false, false, false, kBlockMemory);
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Vec3 point = points[i] / spacing;
    container.put(static_cast<int>(i), point.x(), point.y(), point.z());
  }
  std::vector<std::vector<int>> neighbors(points.size());
  voro::voronoicell_neighbor cell;
  voro::c_loop_all loop(container);
  if (loop.start()) do
      if (container.compute_cell(cell, loop)) cell.neighbors(neighbors[loop.pid()]);
    while (loop.inc());
  return neighbors;
}

/// Returns the points nearer to `points[of]` than to `points[from]`; exactly opposite if the two are exchanged.
HalfSpace nearer(const std::vector<Vec3>& points, int of, int from) {
  const Vec3 &a = points[std::min(of, from)], &b = points[std::max(of, from)];
  const Vec3 normal = (b - a).normalized();
  const HalfSpace nearer_to_a{normal, normal.dot((a + b) / 2)};
  return of < from ? nearer_to_a : nearer_to_a.opposite();
}

}  // namespace

CellPartition voronoi_cells(std::vector<Vec3> points, const Eigen::AlignedBox3d& bounds) {
  const auto before = [](const Vec3& a, const Vec3& b) {
    return std::lexicographical_compare(a.begin(), a.end(), b.begin(), b.end());
  };
  std::sort(points.begin(), points.end(), before);
  points.erase(std::unique(points.begin(), points.end()), points.end());
  Eigen::AlignedBox3d box = bounds;
  for (const Vec3& point : points) box.extend(point);
  const Vec3 margin = Vec3::Constant(0.01 * box.diagonal().norm());
  box = Eigen::AlignedBox3d(Vec3(box.min() - margin), Vec3(box.max() + margin));
  const std::vector<std::vector<int>> neighbors = voronoi_neighbors(points, box);
  CellPartition cells(points.size());
  for (std::size_t i = 0; i < points.size(); ++i) {
    cells[i].splinter = static_cast<int>(i);
    for (const int j : neighbors[i])
      if (j >= 0) cells[i].walls.push_back({nearer(points, static_cast<int>(i), j), j});
  }
  return cells;
}

CellPartition make_voronoi_cells(const VoronoiSplinters& pattern, const Eigen::AlignedBox3d& bounds) {
  const Mat3 map = compression(pattern.grain, pattern.elongation);
  const Eigen::AlignedBox3d compressed = transformed(map, bounds);
  return decompressed(voronoi_cells(jittered_lattice(pattern, compressed), compressed), map);
}

CellPartition make_shard_cells(const TetMesh& mesh, const ShardPattern& pattern) {
  const Mat3 map = compression(pattern.grain, pattern.elongation);
  Eigen::AlignedBox3d bounds;
  for (const Vec3& position : mesh.rest_positions) bounds.extend(Vec3(map * position));
  std::vector<Vec3> points;
  for (const TetId tet : IdRange<TetId>(0, mesh.tet_count())) points.push_back(map * place_in(mesh, tet, pattern));
  return decompressed(voronoi_cells(std::move(points), bounds), map);
}

}  // namespace griffith
