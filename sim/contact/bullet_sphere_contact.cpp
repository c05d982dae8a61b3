#include "sim/contact/bullet_sphere_contact.h"

#include "sim/contact/bullet_sweep.h"

namespace griffith::contact {

void SphereSphereAlgorithm::processCollision(const btCollisionObjectWrapper* first,
                                             const btCollisionObjectWrapper* second, const btDispatcherInfo&,
                                             btManifoldResult* result) {
  const auto placed = [](const btCollisionObjectWrapper* sphere) {
    return PlacedShape{static_cast<const btConvexShape*>(sphere->getCollisionShape()), sphere->getWorldTransform(), 0};
  };
  const Separation apart = separation(placed(first), placed(second));
  result->setPersistentManifold(manifold_);
  if (apart.distance <= manifold_->getContactBreakingThreshold())
    result->addContactPoint(to_bullet(apart.normal), to_bullet(apart.point_on_b), apart.distance);
  result->refreshContactPoints();
}

btCollisionAlgorithm* SphereSphereAlgorithm::Factory::CreateCollisionAlgorithm(
    btCollisionAlgorithmConstructionInfo& info, const btCollisionObjectWrapper* first,
    const btCollisionObjectWrapper* second) {
  void* memory = info.m_dispatcher1->allocateCollisionAlgorithm(sizeof(SphereSphereAlgorithm));
  return new (memory) SphereSphereAlgorithm(info, first, second);
}

}  // namespace griffith::contact
