#include "sim/contact/bullet/shapes.h"

#include <cassert>
#include <limits>

#include "sim/geometry/convex_hull.h"

namespace griffith::contact {
namespace {

/// The margin's share of volume/area, which lies between a third of a hull's inner radius and all of it.
constexpr double kMarginFraction = 0.1;
/// Margin of a sharp hull, as a fraction of that of the rounded one.
constexpr double kSharpFraction = 0.01;
/// The margin of a hull without volume, as a share of its extent.
constexpr double kFlatMarginFraction = 1e-3;

double largest_distance(const std::vector<Vec3>& points, const Vec3& from) {
  double largest = 0;
  for (const Vec3& point : points) largest = std::max(largest, (point - from).norm());
  return largest;
}

void add_points(btConvexHullShape& shape, const std::vector<Vec3>& corners, double margin) {
  shape.setMargin(margin);
  for (const Vec3& corner : corners) shape.addPoint(to_bullet(corner), false);
  shape.recalcLocalAabb();
}

}  // namespace

HullShape::HullShape(const ConvexHull& hull) : hull_(hull) {
  const double size = largest_distance(hull.corners, hull.corners.front());
  const bool solid = hull.volume > 1e-9 * size * size * size;
  const double margin = solid ? kMarginFraction * hull.volume / hull.area : kFlatMarginFraction * size;
  add_points(*this, solid ? shrunken_corners(hull, margin) : hull.corners, margin);
  setCachedLocalAabb(to_bullet(hull_.box_center - hull_.box_half), to_bullet(hull_.box_center + hull_.box_half));
  add_points(sharp_, solid ? shrunken_corners(hull, kSharpFraction * margin) : hull.corners, kSharpFraction * margin);
}

Shape sphere_shape(double radius) {
  assert(radius > 0);
  Shape shape;
  shape.parts.push_back(std::make_shared<btSphereShape>(radius));
  shape.radius = shape.thickness = radius;
  return shape;
}

Shape hull_shape(std::span<const ConvexPart> parts) {
  assert(!parts.empty());
  constexpr double kLeast = 0.02;  // of the radius: among the parts of a jagged body there are slivers
  Shape shape;
  double thinnest = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < parts.size(); ++i) {
    shape.radius = std::max(shape.radius, largest_distance(parts[i], Vec3::Zero()));
    shape.parts.push_back(std::make_shared<HullShape>(convex_hull(parts[i])));
    thinnest = std::min(thinnest, 2 * shape.hull(i).inner_radius);
  }
  shape.thickness = std::clamp(thinnest, kLeast * shape.radius, shape.radius);
  return shape;
}

}  // namespace griffith::contact
