#include "app/editor/placed_surface.h"

#include <algorithm>
#include <cmath>

#include "sim/mesh/tet_mesh.h"
#include "sim/scene/body_pose.h"
#include "sim/world/setup/shape_mesh.h"

namespace griffith::app {
namespace {

/// Returns the faces that only one tet has.
std::vector<std::array<int, 3>> single_faces(const std::vector<std::array<int, 4>>& tets) {
  std::vector<std::array<int, 3>> faces, single;
  for (const std::array<int, 4>& tet : tets)
    for (const auto& corners : kTetFaces) {
      faces.push_back({tet[corners[0]], tet[corners[1]], tet[corners[2]]});
      std::ranges::sort(faces.back());
    }
  std::ranges::sort(faces);
  for (std::size_t i = 0; i < faces.size(); ++i) {
    const bool as_last = i > 0 && faces[i] == faces[i - 1];
    const bool as_next = i + 1 < faces.size() && faces[i] == faces[i + 1];
    if (!as_last && !as_next) single.push_back(faces[i]);
  }
  return single;
}

Vec2 plan(const Vec3& point) { return {point.x(), point.z()}; }

double cross(const Vec2& a, const Vec2& b) { return a.x() * b.y() - a.y() * b.x(); }

/// Returns the height of a triangle above or below a point of the plan; empty if the point is outside, or it is
/// upright.
std::optional<double> height_at(const PlacedSurface& surface, const std::array<int, 3>& triangle, const Vec2& point) {
  const Vec3 &a = surface.points[triangle[0]], &b = surface.points[triangle[1]], &c = surface.points[triangle[2]];
  const Vec2 ab = plan(b) - plan(a), ac = plan(c) - plan(a), ap = point - plan(a);
  const double area = cross(ab, ac);
  if (area == 0) return std::nullopt;
  const double v = cross(ap, ac) / area, w = cross(ab, ap) / area;
  if (v < 0 || w < 0 || v + w > 1) return std::nullopt;
  return a.y() + v * (b.y() - a.y()) + w * (c.y() - a.y());
}

using Edge = std::array<Vec3, 2>;

/// Returns the height of `upper` over `lower` where they cross in the plan; empty if they do not.
std::optional<double> gap_at_crossing(const Edge& upper, const Edge& lower) {
  const Vec2 u = plan(upper[1]) - plan(upper[0]), l = plan(lower[1]) - plan(lower[0]);
  const double sine = cross(u, l);
  if (sine == 0) return std::nullopt;
  const Vec2 way = plan(lower[0]) - plan(upper[0]);
  const double s = cross(way, l) / sine, t = cross(way, u) / sine;
  if (s < 0 || s > 1 || t < 0 || t > 1) return std::nullopt;
  return upper[0].y() + s * (upper[1].y() - upper[0].y()) - lower[0].y() - t * (lower[1].y() - lower[0].y());
}

bool overlap_in_plan(const Eigen::AlignedBox3d& a, const Eigen::AlignedBox3d& b) {
  const auto along = [&](int axis) { return a.min()[axis] <= b.max()[axis] && b.min()[axis] <= a.max()[axis]; };
  return along(0) && along(2);
}

/// Returns the triangles that reach into the box in the plan.
std::vector<std::array<int, 3>> triangles_in(const PlacedSurface& surface, const Eigen::AlignedBox3d& box) {
  std::vector<std::array<int, 3>> found;
  for (const std::array<int, 3>& triangle : surface.triangles) {
    Eigen::AlignedBox3d own;
    for (const int point : triangle) own.extend(surface.points[point]);
    if (overlap_in_plan(own, box)) found.push_back(triangle);
  }
  return found;
}

std::vector<Edge> edges_of(const PlacedSurface& surface, const std::vector<std::array<int, 3>>& triangles) {
  std::vector<std::array<int, 2>> pairs;
  for (const std::array<int, 3>& t : triangles)  // sorted indices
    for (const auto& pair : {std::array{t[0], t[1]}, std::array{t[1], t[2]}, std::array{t[0], t[2]}})
      pairs.push_back(pair);
  std::ranges::sort(pairs);
  const auto [first, last] = std::ranges::unique(pairs);
  pairs.erase(first, last);
  std::vector<Edge> edges;
  for (const auto& [a, b] : pairs) edges.push_back({surface.points[a], surface.points[b]});
  return edges;
}

/// Returns the surface a millionth narrower in the plan, so that sides which touch have no part above each other.
PlacedSurface narrowed(PlacedSurface surface) {
  constexpr double kNarrower = 1e-6;
  const Vec3 center = surface.box.center();
  for (Vec3& point : surface.points)
    for (const int axis : {0, 2}) point[axis] -= kNarrower * (point[axis] - center[axis]);
  surface.box.setEmpty();
  for (const Vec3& point : surface.points) surface.box.extend(point);
  return surface;
}

}  // namespace

Eigen::AlignedBox3d placed_box(const BodyDescription& body, const std::filesystem::path& folder) {
  const Pose pose = pose_of(body);
  Eigen::AlignedBox3d box;
  for (const Vec3& point : make_soup(body.shape, folder).points) box.extend(pose.to_world(point));
  return box;
}

PlacedSurface placed_surface(const BodyDescription& body, const std::filesystem::path& folder) {
  const TetSoup soup = make_soup(body.shape, folder);
  const Pose pose = pose_of(body);
  PlacedSurface surface;
  surface.triangles = single_faces(soup.tets);
  for (const Vec3& point : soup.points) surface.points.push_back(pose.to_world(point));
  for (const std::array<int, 3>& triangle : surface.triangles)
    for (const int point : triangle) surface.box.extend(surface.points[point]);
  return surface;
}

std::optional<double> vertical_gap(const PlacedSurface& given, const PlacedSurface& lower) {
  const PlacedSurface upper = narrowed(given);
  if (!overlap_in_plan(upper.box, lower.box)) return std::nullopt;
  const auto above = triangles_in(upper, lower.box), below = triangles_in(lower, upper.box);
  std::optional<double> gap;
  const auto take = [&](std::optional<double> distance) {
    if (distance && (!gap || *distance < *gap)) gap = distance;
  };
  for (const std::array<int, 3>& a : above)
    for (const std::array<int, 3>& b : below) {
      for (const int point : a)
        if (const auto y = height_at(lower, b, plan(upper.points[point]))) take(upper.points[point].y() - *y);
      for (const int point : b)
        if (const auto y = height_at(upper, a, plan(lower.points[point]))) take(*y - lower.points[point].y());
    }
  const std::vector<Edge> lower_edges = edges_of(lower, below);
  for (const Edge& edge : edges_of(upper, above))
    for (const Edge& other : lower_edges) take(gap_at_crossing(edge, other));
  return gap;
}

}  // namespace griffith::app
