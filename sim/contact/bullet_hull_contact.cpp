#include "sim/contact/bullet_hull_contact.h"

#include <BulletCollision/CollisionDispatch/btCollisionObjectWrapper.h>

#include "sim/contact/bullet_sweep.h"
#include "sim/contact/contact_patch.h"

namespace griffith::contact {
namespace {

std::vector<Vec3> world_corners(const HullShape& hull, const btTransform& transform) {
  std::vector<Vec3> corners;
  for (const btVector3& corner : hull.corners()) corners.push_back(from_bullet(transform * corner));
  return corners;
}

}  // namespace

HullHullAlgorithm::HullHullAlgorithm(const btCollisionAlgorithmConstructionInfo& info,
                                     const btCollisionObjectWrapper* first, const btCollisionObjectWrapper* second)
    : btCollisionAlgorithm(info),
      manifold_(info.m_dispatcher1->getNewManifold(first->getCollisionObject(), second->getCollisionObject())) {}

HullHullAlgorithm::~HullHullAlgorithm() { m_dispatcher->releaseManifold(manifold_); }

void HullHullAlgorithm::processCollision(const btCollisionObjectWrapper* first, const btCollisionObjectWrapper* second,
                                         const btDispatcherInfo&, btManifoldResult* result) {
  result->setPersistentManifold(manifold_);
  const auto& a = *static_cast<const HullShape*>(first->getCollisionShape());
  const auto& b = *static_cast<const HullShape*>(second->getCollisionShape());
  const btScalar reach = manifold_->getContactBreakingThreshold();
  const Separation apart = separation({&a, first->getWorldTransform()}, {&b, second->getWorldTransform()}, reach);
  if (apart.distance < reach) {
    const btVector3 normal = to_bullet(apart.normal);
    const auto patch = contact_patch(world_corners(a, first->getWorldTransform()),
                                     world_corners(b, second->getWorldTransform()), apart.normal, reach);
    for (const PatchPoint& point : patch)
      if (point.distance < reach) result->addContactPoint(normal, to_bullet(point.on_b), point.distance);
    if (patch.empty()) result->addContactPoint(normal, to_bullet(apart.point_on_b), apart.distance);
  }
  result->refreshContactPoints();
}

btCollisionAlgorithm* HullHullAlgorithm::Factory::CreateCollisionAlgorithm(btCollisionAlgorithmConstructionInfo& info,
                                                                           const btCollisionObjectWrapper* first,
                                                                           const btCollisionObjectWrapper* second) {
  void* memory = info.m_dispatcher1->allocateCollisionAlgorithm(sizeof(HullHullAlgorithm));
  return new (memory) HullHullAlgorithm(info, first, second);
}

}  // namespace griffith::contact
