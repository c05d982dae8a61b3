#pragma once

// Private to sim/contact: the collision shapes of the contact world.

#include <btBulletCollisionCommon.h>

#include <memory>
#include <span>
#include <vector>

#include "sim/contact/contact_world.h"
#include "sim/contact/hull.h"

namespace griffith::contact {

inline btVector3 to_bullet(const Vec3& v) { return {v.x(), v.y(), v.z()}; }
inline Vec3 from_bullet(const btVector3& v) { return {v.x(), v.y(), v.z()}; }
inline btTransform to_bullet(const Pose& pose) {
  const Quat& q = pose.rotation;
  return btTransform(btQuaternion(q.x(), q.y(), q.z(), q.w()), to_bullet(pose.translation));
}

/// Gap at which a contact begins, as a fraction of the smaller object's radius.
inline constexpr double kContactReach = 0.02;

/// A convex hull with rounded corners and edges for the direction between two shapes: the corners are moved inward by
/// the margin that the distance algorithm adds again. It finds overlaps up to twice the margin quickly and smoothly.
class HullShape final : public btConvexHullShape {
 public:
  explicit HullShape(const ConvexHull& hull);
  /// Returns the exact polyhedron, for contacts.
  const Hull& hull() const { return hull_; }
  /// Returns the same hull with a hundredth of its margin, for distances between corners and edges.
  const btConvexHullShape& sharp() const { return sharp_; }

 private:
  Hull hull_;
  btConvexHullShape sharp_;
};

/// Shape of an object: convex parts, none for the ground. It is constant, so copies share it.
struct Shape {
  std::vector<std::shared_ptr<btConvexShape>> parts;  ///< in the object's own frame
  double radius = 0;     ///< radius of a sphere around the object's origin that contains all parts [m]
  double thickness = 0;  ///< that of the thinnest part, limited to 0.02 … 1 times the radius [m]

  bool is_sphere() const { return !parts.empty() && parts.front()->getShapeType() == SPHERE_SHAPE_PROXYTYPE; }
  /// Returns the hull of a part that is not a sphere.
  const Hull& hull(std::size_t part) const { return static_cast<const HullShape&>(*parts[part]).hull(); }
};

Shape sphere_shape(double radius);
Shape hull_shape(std::span<const ConvexPart> parts);

}  // namespace griffith::contact
