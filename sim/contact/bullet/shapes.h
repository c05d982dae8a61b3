#pragma once

// Private to sim/contact: the collision shapes of the contact world.

#include <btBulletCollisionCommon.h>

#include <memory>
#include <span>
#include <vector>

#include "sim/contact/contact_world.h"

namespace griffith::contact {

inline btVector3 to_bullet(const Vec3& v) { return {v.x(), v.y(), v.z()}; }
inline Vec3 from_bullet(const btVector3& v) { return {v.x(), v.y(), v.z()}; }
inline btTransform to_bullet(const Pose& pose) {
  const Quat& q = pose.rotation;
  return btTransform(btQuaternion(q.x(), q.y(), q.z(), q.w()), to_bullet(pose.translation));
}

/// A contact begins when a gap is smaller than this share of the smaller object's radius.
inline constexpr double kContactReach = 0.02;
/// The gap at which contacts of an object begin [m].
inline btScalar contact_reach(const btCollisionObject& object) {
  return object.getCollisionShape()->getContactBreakingThreshold(kContactReach);
}

/// A convex hull whose rounded surface is the true surface: the corners are moved inward by the margin that the narrow
/// phase adds again. Overlaps up to twice the margin are then found by the distance algorithm, quickly and smoothly.
class HullShape final : public btConvexHullShape {
 public:
  explicit HullShape(const ConvexPart& corners);
  /// The true corners, for contacts with the ground.
  const std::vector<btVector3>& corners() const { return corners_; }
  /// Wider by the distance at which contacts begin, so that the parts of a compound meet in time.
  void getAabb(const btTransform& transform, btVector3& minimum, btVector3& maximum) const override;
  btScalar getContactBreakingThreshold(btScalar) const override { return contact_reach_; }

 private:
  std::vector<btVector3> corners_;
  btScalar contact_reach_;
};

/// What an object is made of: one convex part, several in a compound, or a plane and no part. Nothing of it changes:
/// copies share it.
struct Shape {
  std::vector<std::shared_ptr<btConvexShape>> parts;  ///< in the object's own frame
  std::shared_ptr<btCollisionShape> whole;            ///< the compound or the plane
  double radius = 0;  ///< of a sphere round the object's origin that holds all parts [m]

  btCollisionShape* root() const { return whole ? whole.get() : parts.front().get(); }
};

Shape sphere_shape(double radius);
/// The half space below `height`, for an object at the origin.
Shape ground_shape(double height);
Shape hull_shape(std::span<const ConvexPart> parts);

}  // namespace griffith::contact
