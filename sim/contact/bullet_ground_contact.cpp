#include "sim/contact/bullet_ground_contact.h"

#include <BulletCollision/CollisionDispatch/btCollisionObjectWrapper.h>

#include "sim/contact/bullet_shapes.h"

namespace griffith::contact {

HullGroundAlgorithm::HullGroundAlgorithm(const btCollisionAlgorithmConstructionInfo& info,
                                         const btCollisionObjectWrapper* hull, const btCollisionObjectWrapper* plane,
                                         bool plane_first)
    : btCollisionAlgorithm(info),
      manifold_(info.m_dispatcher1->getNewManifold(hull->getCollisionObject(), plane->getCollisionObject())),
      plane_first_(plane_first) {}

HullGroundAlgorithm::~HullGroundAlgorithm() { m_dispatcher->releaseManifold(manifold_); }

void HullGroundAlgorithm::processCollision(const btCollisionObjectWrapper* first,
                                           const btCollisionObjectWrapper* second, const btDispatcherInfo&,
                                           btManifoldResult* result) {
  const btCollisionObjectWrapper* hull = plane_first_ ? second : first;
  const btCollisionObjectWrapper* ground = plane_first_ ? first : second;
  const auto* shape = static_cast<const HullShape*>(hull->getCollisionShape());
  const auto* plane = static_cast<const btStaticPlaneShape*>(ground->getCollisionShape());
  const btVector3& normal = plane->getPlaneNormal();
  result->setPersistentManifold(manifold_);
  for (const btVector3& corner : shape->corners()) {
    const btVector3 point = hull->getWorldTransform() * corner;
    const btScalar distance = normal.dot(point) - plane->getPlaneConstant();
    if (distance < manifold_->getContactBreakingThreshold())
      result->addContactPoint(normal, point - distance * normal, distance);
  }
  result->refreshContactPoints();
}

btCollisionAlgorithm* HullGroundAlgorithm::Factory::CreateCollisionAlgorithm(btCollisionAlgorithmConstructionInfo& info,
                                                                             const btCollisionObjectWrapper* first,
                                                                             const btCollisionObjectWrapper* second) {
  void* memory = info.m_dispatcher1->allocateCollisionAlgorithm(sizeof(HullGroundAlgorithm));
  return new (memory) HullGroundAlgorithm(info, m_swapped ? second : first, m_swapped ? first : second, m_swapped);
}

}  // namespace griffith::contact
