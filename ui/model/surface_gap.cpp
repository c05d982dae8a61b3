#include "ui/model/surface_gap.h"

#include <algorithm>
#include <cmath>

namespace griffith::ui {
namespace {

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

using IndexPair = std::array<int, 2>;

std::vector<IndexPair> edges_of(const std::vector<std::array<int, 3>>& triangles) {
  std::vector<IndexPair> pairs;
  for (const std::array<int, 3>& t : triangles)  // sorted indices
    for (const auto& pair : {IndexPair{t[0], t[1]}, IndexPair{t[1], t[2]}, IndexPair{t[0], t[2]}})
      pairs.push_back(pair);
  std::ranges::sort(pairs);
  const auto [first, last] = std::ranges::unique(pairs);
  pairs.erase(first, last);
  return pairs;
}

/// A part of a surface with its extent along x.
template <class Part>
struct Spread {
  double low, high;
  Part part;
};

/// Returns parts of a surface in the order of their lower ends along x.
template <class Part>
std::vector<Spread<Part>> sorted_parts(const PlacedSurface& surface, const std::vector<Part>& parts) {
  std::vector<Spread<Part>> sorted;
  for (const Part& part : parts) {
    Spread<Part> spread{surface.points[part[0]].x(), surface.points[part[0]].x(), part};
    for (const int point : part) {
      spread.low = std::min(spread.low, surface.points[point].x());
      spread.high = std::max(spread.high, surface.points[point].x());
    }
    sorted.push_back(spread);
  }
  std::ranges::stable_sort(sorted, {}, &Spread<Part>::low);
  return sorted;
}

/// Calls `action` with the parts of two surfaces that share a coordinate x.
template <class Part, class Action>
void for_each_near(const PlacedSurface& upper, const std::vector<Part>& above, const PlacedSurface& lower,
                   const std::vector<Part>& below, Action action) {
  const std::vector<Spread<Part>> sorted = sorted_parts(lower, below);
  double widest = 0;
  for (const Spread<Part>& spread : sorted) widest = std::max(widest, spread.high - spread.low);
  for (const Spread<Part>& a : sorted_parts(upper, above)) {
    auto b = std::ranges::lower_bound(sorted, a.low - widest, {}, &Spread<Part>::low);
    for (; b != sorted.end() && b->low <= a.high; ++b)
      if (b->high >= a.low) action(a.part, b->part);
  }
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

/// Returns the surface rotated so that the direction points up.
PlacedSurface upright(PlacedSurface surface, const Quat& rotation) {
  surface.box.setEmpty();
  for (Vec3& point : surface.points) surface.box.extend(point = rotation * point);
  return surface;
}

}  // namespace

std::optional<double> vertical_gap(const PlacedSurface& given, const PlacedSurface& lower) {
  const PlacedSurface upper = narrowed(given);
  if (!overlap_in_plan(upper.box, lower.box)) return std::nullopt;
  const auto above = triangles_in(upper, lower.box), below = triangles_in(lower, upper.box);
  std::optional<double> gap;
  const auto take = [&](std::optional<double> distance) {
    if (distance && (!gap || *distance < *gap)) gap = distance;
  };
  for_each_near(upper, above, lower, below, [&](const auto& a, const auto& b) {
    for (const int point : a)
      if (const auto y = height_at(lower, b, plan(upper.points[point]))) take(upper.points[point].y() - *y);
    for (const int point : b)
      if (const auto y = height_at(upper, a, plan(lower.points[point]))) take(*y - lower.points[point].y());
  });
  for_each_near(upper, edges_of(above), lower, edges_of(below), [&](const auto& a, const auto& b) {
    take(gap_at_crossing({upper.points[a[0]], upper.points[a[1]]}, {lower.points[b[0]], lower.points[b[1]]}));
  });
  return gap;
}

std::optional<double> gap_along(const Vec3& direction, const PlacedSurface& ahead, const PlacedSurface& behind) {
  const Quat rotation = Quat::FromTwoVectors(direction, Vec3::UnitY());
  return vertical_gap(upright(ahead, rotation), upright(behind, rotation));
}

void move_surface(PlacedSurface& surface, const Vec3& offset) {
  for (Vec3& point : surface.points) point += offset;
  surface.box.translate(offset);
}

}  // namespace griffith::ui
