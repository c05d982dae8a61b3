#include "app/bake/fill_holes.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

namespace griffith::app {
namespace {

/// Maps each point to the first point at the same position.
std::vector<int> welded(const std::vector<Vec3>& points, double tolerance) {
  using Cell = std::array<std::int64_t, 3>;
  const auto cell_of = [&](const Vec3& point) {
    Cell cell;
    for (int axis = 0; axis < 3; ++axis) cell[axis] = std::llround(point[axis] / (2 * tolerance));
    return cell;
  };
  std::map<Cell, std::vector<int>> cells;
  const auto point_near = [&](int i) {
    const Cell center = cell_of(points[i]);
    for (int neighbor = 0; neighbor < 27; ++neighbor) {
      const Cell cell = {center[0] + neighbor % 3 - 1, center[1] + neighbor / 3 % 3 - 1, center[2] + neighbor / 9 - 1};
      const auto found = cells.find(cell);
      if (found == cells.end()) continue;
      for (const int other : found->second)
        if ((points[other] - points[i]).norm() <= tolerance) return other;
    }
    cells[center].push_back(i);
    return i;
  };
  std::vector<int> first(points.size());
  for (int i = 0; i < std::ssize(points); ++i) first[i] = point_near(i);
  return first;
}

/// Edges without an opposite edge in another polygon: targets by start point; each point has as many incoming as
/// outgoing ones.
using OpenEdges = std::map<int, std::vector<int>>;

OpenEdges open_edges(const PieceSurface& surface, const std::vector<int>& first) {
  std::map<std::pair<int, int>, int> counts;
  for (const std::vector<int>& polygon : surface.polygons)
    for (std::size_t i = 0; i < polygon.size(); ++i) {
      const int a = first[polygon[i]], b = first[polygon[(i + 1) % polygon.size()]];
      if (a != b) counts[std::minmax(a, b)] += a < b ? 1 : -1;
    }
  OpenEdges open;
  for (const auto& [edge, count] : counts)
    for (int i = 0; i < std::abs(count); ++i)
      count > 0 ? open[edge.first].push_back(edge.second) : open[edge.second].push_back(edge.first);
  return open;
}

/// Chains all edges into loops that visit no point twice.
std::vector<std::vector<int>> loops_of(OpenEdges open) {
  std::vector<std::vector<int>> loops;
  for (auto& [start, ends] : open) {
    std::vector<int> path = {start};
    while (!open[path.back()].empty()) {
      std::vector<int>& out = open[path.back()];
      const int next = out.back();
      out.pop_back();
      const auto seen = std::ranges::find(path, next);
      if (seen == path.end()) {
        path.push_back(next);
        continue;
      }
      loops.emplace_back(seen, path.end());
      path.erase(seen + 1, path.end());
    }
  }
  return loops;
}

/// The triangulation of least area of a loop; least[i, k] is the least area for its points from i to k.
class LoopFilling {
 public:
  LoopFilling(const std::vector<Vec3>& points, const std::vector<int>& loop)
      : loop_(loop), best_(loop.size() * loop.size(), -1), least_(loop.size() * loop.size(), 0) {
    const int size = static_cast<int>(loop.size());
    for (int span = 2; span < size; ++span)
      for (int i = 0; i + span < size; ++i) {
        const int k = i + span;
        double& minimum = least_[at(i, k)] = std::numeric_limits<double>::infinity();
        for (int m = i + 1; m < k; ++m) {
          const Vec3& middle = points[loop[m]];
          const double area = (points[loop[i]] - middle).cross(points[loop[k]] - middle).norm() / 2;
          const double sum = least_[at(i, m)] + least_[at(m, k)] + area;
          if (sum < minimum) minimum = sum, best_[at(i, k)] = m;
        }
      }
  }

  /// Adds the triangles, with the orientation opposite to the loop.
  void add_to(std::vector<std::array<int, 3>>& triangles) const {
    std::vector<std::pair<int, int>> waiting = {{0, static_cast<int>(loop_.size()) - 1}};
    while (!waiting.empty()) {
      const auto [i, k] = waiting.back();
      waiting.pop_back();
      if (k - i < 2) continue;
      const int m = best_[at(i, k)];
      triangles.push_back({loop_[k], loop_[m], loop_[i]});
      waiting.insert(waiting.end(), {{i, m}, {m, k}});
    }
  }

 private:
  std::size_t at(int i, int k) const {
    return static_cast<std::size_t>(i) * loop_.size() + static_cast<std::size_t>(k);
  }

  const std::vector<int>& loop_;
  std::vector<int> best_;      ///< third corner of the triangle on the chord from i to k
  std::vector<double> least_;  ///< [m²]
};

/// Returns the smallest height of a triangle.
double height_of(const std::array<int, 3>& triangle, const std::vector<Vec3>& points) {
  const Vec3 &a = points[triangle[0]], &b = points[triangle[1]], &c = points[triangle[2]];
  return (b - a).cross(c - a).norm() / std::max({(b - a).norm(), (c - b).norm(), (a - c).norm()});
}

}  // namespace

std::vector<std::array<int, 3>> hole_triangles(const PieceSurface& surface) {
  constexpr double kTolerance = 1e-5;  // fraction of the diagonal
  Eigen::AlignedBox3d box;
  for (const Vec3& point : surface.points) box.extend(point);
  if (box.isEmpty()) return {};
  const double tolerance = kTolerance * box.diagonal().norm();
  std::vector<std::array<int, 3>> triangles;
  for (const std::vector<int>& loop : loops_of(open_edges(surface, welded(surface.points, tolerance))))
    LoopFilling(surface.points, loop).add_to(triangles);
  std::erase_if(triangles, [&](const auto& triangle) { return height_of(triangle, surface.points) <= tolerance; });
  return triangles;
}

void fill_holes(PieceSurface& surface, const std::vector<std::array<int, 3>>& triangles) {
  for (const std::array<int, 3>& triangle : triangles) {
    std::vector<int>& polygon = surface.polygons.emplace_back();
    for (const int corner : triangle) {
      polygon.push_back(static_cast<int>(surface.points.size()));
      surface.points.push_back(Vec3(surface.points[corner]));
    }
    surface.looks.push_back(Look::inside);
  }
  pad(surface);
}

}  // namespace griffith::app
