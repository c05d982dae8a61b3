#include "sim/contact/bullet/sweep.h"

#include <BulletCollision/CollisionShapes/btUniformScalingShape.h>
#include <BulletCollision/NarrowPhaseCollision/btGjkEpaPenetrationDepthSolver.h>
#include <BulletCollision/NarrowPhaseCollision/btGjkPairDetector.h>
#include <BulletCollision/NarrowPhaseCollision/btPointCollector.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace griffith::contact {
namespace {

/// Shapes with a thinner margin are small: less than some centimeters [m].
constexpr double kSmallMargin = 2e-3;
/// Difference of the distances of rounded and true hulls that is a rounding error, in margins.
constexpr double kExact = 1e-3;

bool is_sphere(const PlacedShape& shape) { return shape.convex->getShapeType() == SPHERE_SHAPE_PROXYTYPE; }

/// Returns the least of n · x over the points x of a convex shape, n a unit vector: of a hull as it is, not rounded.
double lowest(const PlacedShape& shape, const Vec3& normal) {
  const double margin = shape.convex->getMargin(), center = normal.dot(from_bullet(shape.transform.getOrigin()));
  if (is_sphere(shape)) return center - margin;
  const Hull& hull = static_cast<const HullShape*>(shape.convex)->hull();
  return center + hull.lowest(from_bullet(to_bullet(normal) * shape.transform.getBasis())) -
         (hull.is_solid() ? 0 : margin);
}

double highest(const PlacedShape& shape, const Vec3& normal) { return -lowest(shape, -normal); }

Separation separation_from_ground(const PlacedShape& shape, double height) {
  const btVector3 down(0, -1, 0);
  const btVector3 local = shape.convex->localGetSupportingVertex(down * shape.transform.getBasis());
  const Vec3 foot = from_bullet(shape.transform * local);
  return {lowest(shape, Vec3::UnitY()) - height, Vec3::UnitY(), Vec3(foot.x(), height, foot.z())};
}

Separation separation(const btConvexShape& a, const btTransform& a_place, const btConvexShape& b,
                      const btTransform& b_place) {
  btVoronoiSimplexSolver simplex;
  btGjkEpaPenetrationDepthSolver penetration;
  btGjkPairDetector detector(&a, &b, &simplex, &penetration);
  btGjkPairDetector::ClosestPointInput input;
  input.m_transformA = a_place;
  input.m_transformB = b_place;
  btPointCollector closest;
  detector.getClosestPoints(input, closest, nullptr);
  if (!closest.m_hasResult) return {std::numeric_limits<double>::infinity(), Vec3::UnitY(), Vec3::Zero()};
  return {closest.m_distance, from_bullet(closest.m_normalOnBInWorld), from_bullet(closest.m_pointInWorld)};
}

/// Returns the separation of rounded shapes. Bullet's tolerances are lengths, areas and volumes: small shapes are
/// enlarged for it.
Separation rounded_separation(const PlacedShape& a, const PlacedShape& b) {
  const double thinner = std::min(a.convex->getMargin(), b.convex->getMargin());
  if (thinner >= kSmallMargin) return separation(*a.convex, a.transform, *b.convex, b.transform);
  const double scale = std::exp2(std::ceil(std::log2(kSmallMargin / thinner)));
  btUniformScalingShape large_a(const_cast<btConvexShape*>(a.convex), scale);
  btUniformScalingShape large_b(const_cast<btConvexShape*>(b.convex), scale);
  const btVector3 origin = b.transform.getOrigin();
  const btTransform a_place(a.transform.getBasis(), scale * (a.transform.getOrigin() - origin));
  const btTransform b_place(b.transform.getBasis(), btVector3(0, 0, 0));
  Separation apart = separation(large_a, a_place, large_b, b_place);
  apart.distance /= scale;
  apart.point_on_b = apart.point_on_b / scale + from_bullet(origin);
  return apart;
}

/// Returns the separation of two shapes as they are along the normal of their rounded ones, at most their distance.
Separation unrounded(const PlacedShape& a, const PlacedShape& b, Separation apart) {
  if (!std::isfinite(apart.distance) || apart.normal.isZero()) return apart;
  const double surface_of_b = highest(b, apart.normal);
  apart.distance = lowest(a, apart.normal) - surface_of_b;
  apart.point_on_b += (surface_of_b - apart.normal.dot(apart.point_on_b)) * apart.normal;
  return apart;
}

PlacedShape sharpened(PlacedShape shape) {
  if (!is_sphere(shape)) shape.convex = &static_cast<const HullShape*>(shape.convex)->sharp();
  return shape;
}

/// Returns the separation of two spheres, whose margins are their radii.
Separation separation_of_spheres(const PlacedShape& a, const PlacedShape& b) {
  const Vec3 center = from_bullet(b.transform.getOrigin()), apart = from_bullet(a.transform.getOrigin()) - center;
  const double distance = apart.norm();
  const Vec3 normal = distance > 0 ? Vec3(apart / distance) : Vec3::UnitY();
  return {distance - a.convex->getMargin() - b.convex->getMargin(), normal, center + b.convex->getMargin() * normal};
}

}  // namespace

Separation separation(const PlacedShape& a, const PlacedShape& b) {
  if (!b.convex) return separation_from_ground(a, b.ground_height);
  if (is_sphere(a) && is_sphere(b)) return separation_of_spheres(a, b);
  const Separation rounded = rounded_separation(a, b), apart = unrounded(a, b, rounded);
  const double margin = std::min(a.convex->getMargin(), b.convex->getMargin());
  if (rounded.distance - apart.distance < kExact * margin) return apart;  // of faces
  const Separation sharp = unrounded(a, b, rounded_separation(sharpened(a), sharpened(b)));
  return std::isfinite(sharp.distance) && sharp.distance > apart.distance ? sharp : apart;
}

bool comes_nearer(const Vec3& displacement, const Vec3& normal) {
  return -normal.dot(displacement) > 1e-9 * displacement.norm();
}

double nearest_distance(const Vec3& start, const Vec3& displacement) {
  const double length_squared = displacement.squaredNorm();
  const double nearest = length_squared > 0 ? std::clamp(-start.dot(displacement) / length_squared, 0.0, 1.0) : 0;
  return (start + nearest * displacement).norm();
}

bool boxes_meet(const PlacedShape& moving, const Vec3& displacement, const PlacedShape& other, double gap) {
  btVector3 low, high, other_low, other_high;
  moving.convex->getAabb(moving.transform, low, high);
  other.convex->getAabb(other.transform, other_low, other_high);
  for (int axis = 0; axis < 3; ++axis) {
    const double reach = std::max(gap, 0.0) + 1e-9 * std::abs(displacement[axis]);
    if (low[axis] + std::min(displacement[axis], 0.0) > other_high[axis] + reach) return false;
    if (high[axis] + std::max(displacement[axis], 0.0) < other_low[axis] - reach) return false;
  }
  return true;
}

std::optional<Touch> first_touch(PlacedShape moving, const Vec3& displacement, const PlacedShape& other, double gap) {
  constexpr int kMaxAdvances = 32;
  if (other.convex && !boxes_meet(moving, displacement, other, gap)) return std::nullopt;
  const double tolerance = 1e-9 * (displacement.norm() + std::abs(gap));
  const btVector3 start = moving.transform.getOrigin();
  Touch touch{0, Vec3::Zero()};
  for (int i = 0; i < kMaxAdvances; ++i) {
    moving.transform.setOrigin(start + touch.fraction * to_bullet(displacement));
    const Separation apart = separation(moving, other);
    touch.normal = apart.normal;
    if (apart.distance <= gap + tolerance) return touch;
    if (!comes_nearer(displacement, apart.normal)) return std::nullopt;
    const double approach = -apart.normal.dot(displacement);
    touch.fraction += (apart.distance - gap) / approach;
    if (touch.fraction > 1) return std::nullopt;
  }
  return touch;
}

}  // namespace griffith::contact
