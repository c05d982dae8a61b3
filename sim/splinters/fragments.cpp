#include "sim/splinters/fragments.h"

#include <algorithm>
#include <array>
#include <unordered_set>

#include "sim/core/parallel.h"
#include "sim/mesh/topology.h"

namespace griffith {
namespace {

/// Planes nearer to a corner than this fraction of the body's size go through it.
constexpr double kTolerance = 1e-10;

std::array<Vec3, 4> rest_corners(const TetMesh& mesh, TetId tet) {
  std::array<Vec3, 4> corners;
  for (int i = 0; i < 4; ++i) corners[i] = mesh.rest_positions[mesh.tets[tet][i]];
  return corners;
}

/// True if a single wall separates the tet from the cell: the most frequent case, and the cheapest to test.
bool misses(const std::array<Vec3, 4>& corners, const ConvexCell& cell, double tolerance) {
  return std::ranges::any_of(cell.walls, [&](const CellWall& wall) {
    return std::ranges::all_of(corners, [&](const Vec3& corner) { return wall.inside.distance(corner) > -tolerance; });
  });
}

ConvexPolyhedron common_part(const std::array<Vec3, 4>& corners, const ConvexCell& cell, double tolerance) {
  if (misses(corners, cell, tolerance)) return {};
  ConvexPolyhedron part = tet_polyhedron(corners);
  for (std::size_t i = 0; i < cell.walls.size() && !part.empty(); ++i) {
    const HalfSpace& inside = cell.walls[i].inside;
    const bool cuts =
        std::ranges::any_of(corners, [&](const Vec3& corner) { return inside.distance(corner) > -tolerance; });
    if (cuts) clip(part, inside, static_cast<int>(i), tolerance);
  }
  return part;
}

/// Spreads from the cell at the tet's center to the neighbors of all cells that meet the tet.
std::vector<Fragment> fragments_of_tet(const TetMesh& mesh, const CellPartition& cells, TetId tet, int start,
                                       double tolerance) {
  const std::array<Vec3, 4> corners = rest_corners(mesh, tet);
  std::vector<Fragment> fragments;
  std::vector<int> waiting = {start};
  std::unordered_set<int> seen = {start};
  while (!waiting.empty()) {
    const int cell = waiting.back();
    waiting.pop_back();
    Fragment fragment{tet, cell, common_part(corners, cells[cell], tolerance)};
    if (fragment.polyhedron.empty()) continue;
    fragment.volume = volume(fragment.polyhedron);
    fragments.push_back(std::move(fragment));
    for (const CellWall& wall : cells[cell].walls) {
      if (wall.neighbor >= 0 && seen.insert(wall.neighbor).second) waiting.push_back(wall.neighbor);
    }
  }
  std::ranges::sort(fragments, {}, &Fragment::cell);
  return fragments;
}

double size_of(const TetMesh& mesh) {
  Eigen::AlignedBox3d box;
  for (const Vec3& position : mesh.rest_positions) box.extend(position);
  return box.diagonal().norm();
}

}  // namespace

std::vector<Fragment> make_fragments(const TetMesh& mesh, const CellPartition& cells, const Monitor& monitor) {
  const double tolerance = kTolerance * size_of(mesh);
  std::vector<std::vector<Fragment>> by_tet(mesh.tets.size());
  parallel_for(mesh.tet_count(), 16, [&](int begin, int end) {
    if (monitor.is_cancelled()) return;
    int start = 0;
    for (const TetId tet : IdRange<TetId>(begin, end)) {
      start = locate(cells, rest_centroid(mesh, tet), start);
      by_tet[tet] = fragments_of_tet(mesh, cells, tet, start, tolerance);
    }
  });
  if (monitor.is_cancelled()) throw Cancelled();
  std::vector<Fragment> fragments;
  for (std::vector<Fragment>& of_tet : by_tet) std::ranges::move(of_tet, std::back_inserter(fragments));
  return fragments;
}

}  // namespace griffith
