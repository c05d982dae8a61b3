#include "sim/contact/bullet/sphere_contact.h"

#include "sim/contact/bullet/sweep.h"

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

SphereHullAlgorithm::SphereHullAlgorithm(const btCollisionAlgorithmConstructionInfo& info,
                                         const btCollisionObjectWrapper* first, const btCollisionObjectWrapper* second)
    : ManifoldAlgorithm(info, first, second), bullet_(manifold_, info, first, second, &solver_, 0, 0) {}

void SphereHullAlgorithm::processCollision(const btCollisionObjectWrapper* first,
                                           const btCollisionObjectWrapper* second, const btDispatcherInfo& info,
                                           btManifoldResult* result) {
  bullet_.processCollision(first, second, info, result);
  result->refreshContactPoints();
}

SphereGroundAlgorithm::SphereGroundAlgorithm(const btCollisionAlgorithmConstructionInfo& info,
                                             const btCollisionObjectWrapper* first,
                                             const btCollisionObjectWrapper* second, bool plane_first)
    : ManifoldAlgorithm(info, plane_first ? second : first, plane_first ? first : second),
      bullet_(manifold_, info, first, second, plane_first, 1, 0) {}

void SphereGroundAlgorithm::processCollision(const btCollisionObjectWrapper* first,
                                             const btCollisionObjectWrapper* second, const btDispatcherInfo& info,
                                             btManifoldResult* result) {
  bullet_.processCollision(first, second, info, result);
  result->refreshContactPoints();
}

}  // namespace griffith::contact
