#include "sim/contact/bullet/hull_contact.h"

#include <BulletCollision/CollisionDispatch/btCollisionObjectWrapper.h>

#include <algorithm>

#include "sim/contact/bullet/sweep.h"
#include "sim/contact/contact_patch.h"

namespace griffith::contact {
namespace {

std::vector<Vec3> world_corners(const PlacedHull& hull) {
  std::vector<Vec3> corners;
  for (const btVector3& corner : hull.shape.corners()) corners.push_back(from_bullet(hull.transform * corner));
  return corners;
}

/// How far a hull reaches along a direction [m].
btScalar extent_along(const PlacedHull& hull, const btVector3& direction) {
  const btVector3 local = direction * hull.transform.getBasis();
  btScalar extent = -BT_LARGE_FLOAT;
  for (const btVector3& corner : hull.shape.corners()) extent = std::max(extent, local.dot(corner));
  return extent + direction.dot(hull.transform.getOrigin());
}

}  // namespace

PlacedHull placed_hull(const btCollisionObjectWrapper& wrapper) {
  return {*static_cast<const HullShape*>(wrapper.getCollisionShape()), wrapper.getWorldTransform()};
}

HullHullAlgorithm::HullHullAlgorithm(const btCollisionAlgorithmConstructionInfo& info,
                                     const btCollisionObjectWrapper* first, const btCollisionObjectWrapper* second)
    : PairAlgorithm(info, first, second),
      reach_(std::min(contact_reach(*first->getCollisionObject()), contact_reach(*second->getCollisionObject()))) {
  const std::optional<PairMemory> memory = take_memory();
  if (!memory) return;
  parting_direction_ = memory->parting_direction;
  seen_from_b_ = memory->seen_from_b;
  normal_in_b_ = memory->normal_in_b;
}

PairMemory HullHullAlgorithm::memory() const {
  PairMemory memory = PairAlgorithm::memory();
  memory.parting_direction = parting_direction_;
  memory.seen_from_b = seen_from_b_;
  memory.normal_in_b = normal_in_b_;
  return memory;
}

void HullHullAlgorithm::processCollision(const btCollisionObjectWrapper* first, const btCollisionObjectWrapper* second,
                                         const btDispatcherInfo&, btManifoldResult* result) {
  const PlacedHull b = placed_hull(*second);
  find(placed_hull(*first), b);
  note(b, *result);
}

void HullHullAlgorithm::find(const PlacedHull& a, const PlacedHull& b) {
  const btVector3 direction = to_bullet(parting_direction_);
  const bool parted =
      !parting_direction_.isZero(0) && -extent_along(a, -direction) - extent_along(b, direction) > reach_;
  if (parted) {
    found_ = Found::nothing;
  } else if (manifold_ && manifold_->getNumContacts() > 0 && hardly_moved(a, b)) {
    found_ = Found::the_same;
  } else {
    find_anew(a, b);
  }
}

void HullHullAlgorithm::note(const PlacedHull& b, btManifoldResult& result) {
  if (found_ == Found::nothing) return release_manifold();
  if (!manifold_) make_manifold();
  result.setPersistentManifold(manifold_);
  if (found_ == Found::the_same) carry_contacts(b);
  if (found_ == Found::anew)
    for (const PatchPoint& point : points_) result.addContactPoint(normal_, to_bullet(point.on_b), point.distance);
  result.refreshContactPoints();
  if (manifold_->getNumContacts() == 0) release_manifold();
}

/// Whether the contacts that were found are still those that would be: any that are new lie near the end of the reach.
bool HullHullAlgorithm::hardly_moved(const PlacedHull& a, const PlacedHull& b) const {
  constexpr btScalar kFractionOfReach = 0.1;
  const btTransform now = b.transform.inverse() * a.transform;
  const btScalar radius = a.shape.getContactBreakingThreshold(0) / kContactReach;  // of a about its centre
  btVector3 turned(0, 0, 0);
  for (int i = 0; i < 3; ++i) turned[i] = (now.getBasis().getColumn(i) - seen_from_b_.getBasis().getColumn(i)).length();
  const btScalar moved = (now.getOrigin() - seen_from_b_.getOrigin()).length() + radius * turned.length();
  return moved < kFractionOfReach * reach_;
}

/// Turns the normals with the pair; Bullet's refresh moves the points and takes their distances along them.
void HullHullAlgorithm::carry_contacts(const PlacedHull& b) {
  for (int i = 0; i < manifold_->getNumContacts(); ++i)
    manifold_->getContactPoint(i).m_normalWorldOnB = b.transform.getBasis() * normal_in_b_;
}

void HullHullAlgorithm::find_anew(const PlacedHull& a, const PlacedHull& b) {
  const Separation apart = separation({&a.shape, a.transform}, {&b.shape, b.transform});
  parting_direction_ = apart.normal;
  found_ = Found::nothing;
  if (apart.distance >= reach_) return;
  found_ = Found::anew;
  points_ = contact_patch(world_corners(a), world_corners(b), apart.normal, reach_);
  if (points_.empty()) points_.push_back({apart.point_on_b, apart.distance});
  std::erase_if(points_, [&](const PatchPoint& point) { return point.distance >= reach_; });
  normal_ = to_bullet(apart.normal);
  normal_in_b_ = normal_ * b.transform.getBasis();
  seen_from_b_ = b.transform.inverse() * a.transform;
}

}  // namespace griffith::contact
