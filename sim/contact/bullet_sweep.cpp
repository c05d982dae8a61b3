#include "sim/contact/bullet_sweep.h"

#include <BulletCollision/NarrowPhaseCollision/btGjkEpaPenetrationDepthSolver.h>
#include <BulletCollision/NarrowPhaseCollision/btGjkPairDetector.h>
#include <BulletCollision/NarrowPhaseCollision/btPointCollector.h>

#include <cmath>
#include <limits>

namespace griffith::contact {
namespace {

Separation separation_from_ground(const PlacedShape& shape, double height) {
  const btVector3 down(0, -1, 0);
  const btVector3 local = shape.convex->localGetSupportingVertex(down * shape.transform.getBasis());
  const Vec3 lowest = from_bullet(shape.transform * local);
  return {lowest.y() - height, Vec3::UnitY(), Vec3(lowest.x(), height, lowest.z())};
}

}  // namespace

Separation separation(const PlacedShape& a, const PlacedShape& b) {
  if (!b.convex) return separation_from_ground(a, b.ground_height);
  btVoronoiSimplexSolver simplex;
  btGjkEpaPenetrationDepthSolver penetration;
  btGjkPairDetector detector(a.convex, b.convex, &simplex, &penetration);
  btGjkPairDetector::ClosestPointInput input;
  input.m_transformA = a.transform;
  input.m_transformB = b.transform;
  btPointCollector closest;
  detector.getClosestPoints(input, closest, nullptr);
  if (!closest.m_hasResult) return {std::numeric_limits<double>::infinity(), Vec3::UnitY(), Vec3::Zero()};
  return {closest.m_distance, from_bullet(closest.m_normalOnBInWorld), from_bullet(closest.m_pointInWorld)};
}

bool comes_nearer(const Vec3& displacement, const Vec3& normal) {
  return -normal.dot(displacement) > 1e-9 * displacement.norm();
}

std::optional<Touch> first_touch(PlacedShape moving, const Vec3& displacement, const PlacedShape& other, double gap) {
  constexpr int kMaxAdvances = 32;
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
