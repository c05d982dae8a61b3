#include "sim/contact/bullet/ground_contact.h"

#include <algorithm>

#include "sim/contact/bullet/shapes.h"

namespace griffith::contact {

HullGroundAlgorithm::HullGroundAlgorithm(const btCollisionAlgorithmConstructionInfo& info,
                                         const btCollisionObjectWrapper* first, const btCollisionObjectWrapper* second,
                                         bool plane_first)
    : ManifoldAlgorithm(info, plane_first ? second : first, plane_first ? first : second), plane_first_(plane_first) {}

void HullGroundAlgorithm::processCollision(const btCollisionObjectWrapper* first,
                                           const btCollisionObjectWrapper* second, const btDispatcherInfo&,
                                           btManifoldResult* result) {
  const btCollisionObjectWrapper* hull = plane_first_ ? second : first;
  const btCollisionObjectWrapper* ground = plane_first_ ? first : second;
  const auto* shape = static_cast<const HullShape*>(hull->getCollisionShape());
  const auto* plane = static_cast<const btStaticPlaneShape*>(ground->getCollisionShape());
  const btVector3& normal = plane->getPlaneNormal();
  result->setPersistentManifold(manifold_);
  const auto height_of = [&](const btVector3& corner) {
    return normal.dot(hull->getWorldTransform() * corner) - plane->getPlaneConstant();
  };
  btScalar lowest = BT_LARGE_FLOAT, highest = -BT_LARGE_FLOAT;
  for (const btVector3& corner : shape->corners()) {
    lowest = std::min(lowest, height_of(corner));
    highest = std::max(highest, height_of(corner));
  }
  // A thin slab's upper side is within reach too. A manifold has room for four: it must not take the lower side's.
  const btScalar reach = std::min(manifold_->getContactBreakingThreshold(), (lowest + highest) / 2);
  for (const btVector3& corner : shape->corners()) {
    const btScalar distance = height_of(corner);
    if (distance > reach) continue;
    result->addContactPoint(normal, hull->getWorldTransform() * corner - distance * normal, distance);
  }
  result->refreshContactPoints();
}

}  // namespace griffith::contact
