#pragma once

// Private to sim/contact.

#include <btBulletCollisionCommon.h>

#include <vector>

#include "sim/contact/bullet/pair.h"
#include "sim/contact/bullet/shapes.h"
#include "sim/contact/contact_patch.h"

namespace griffith::contact {

struct PlacedHull {
  const HullShape& shape;
  const btTransform& transform;
};

/// The hull that an object or a part of one has; void when the object goes or moves.
PlacedHull placed_hull(const btCollisionObjectWrapper& wrapper);

/// Contacts of two hulls: all corners of the area where they meet at once, where Bullet's own algorithm finds one point
/// a step. So a face that strikes a face does not turn it, and stacks stand. Most pairs with near bounding boxes do not
/// touch: they have no manifold, and as long as the plane that parted them last still does, nothing else is computed.
/// Of those that touch most hardly move against each other: their points are carried along until they have.
class HullHullAlgorithm final : public PairAlgorithm {
 public:
  HullHullAlgorithm(const btCollisionAlgorithmConstructionInfo& info, const btCollisionObjectWrapper* first,
                    const btCollisionObjectWrapper* second);
  void processCollision(const btCollisionObjectWrapper* first, const btCollisionObjectWrapper* second,
                        const btDispatcherInfo&, btManifoldResult* result) override;
  /// What processCollision() does, in two parts. Finding changes nothing but the algorithm itself: many may do it at
  /// once.
  void find(const PlacedHull& a, const PlacedHull& b);
  void note(const PlacedHull& b, btManifoldResult& result);
  PairMemory memory() const override;

 private:
  void find_anew(const PlacedHull& a, const PlacedHull& b);
  bool hardly_moved(const PlacedHull& a, const PlacedHull& b) const;
  void carry_contacts(const PlacedHull& b);

  btScalar reach_;                         // gap at which contacts begin [m]
  Vec3 parting_direction_ = Vec3::Zero();  // unit, from the second to the first; zero while unknown
  enum class Found { nothing, the_same, anew } found_ = Found::nothing;
  std::vector<PatchPoint> points_;  // found anew, with their normal
  btVector3 normal_;
  btTransform seen_from_b_;  // where a was in b's frame when the contacts were found
  btVector3 normal_in_b_;    // of these contacts
};

}  // namespace griffith::contact
