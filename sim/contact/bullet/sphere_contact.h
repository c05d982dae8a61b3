#pragma once

// Private to sim/contact.

#include <BulletCollision/CollisionDispatch/btConvexConvexAlgorithm.h>
#include <BulletCollision/CollisionDispatch/btConvexPlaneCollisionAlgorithm.h>
#include <BulletCollision/NarrowPhaseCollision/btGjkEpaPenetrationDepthSolver.h>

#include "sim/contact/bullet/pair.h"

namespace griffith::contact {

/// The contact of two spheres in closed form, from within reach to one inside the other. Bullet's own algorithm for two
/// spheres sees them when they overlap only, its general one takes a thousand times as long where they overlap by far.
class SphereSphereAlgorithm final : public ManifoldAlgorithm {
 public:
  using ManifoldAlgorithm::ManifoldAlgorithm;
  void processCollision(const btCollisionObjectWrapper* first, const btCollisionObjectWrapper* second,
                        const btDispatcherInfo&, btManifoldResult* result) override;
};

/// Bullet's own algorithm for a sphere and a hull, on a manifold that can be read.
class SphereHullAlgorithm final : public ManifoldAlgorithm {
 public:
  SphereHullAlgorithm(const btCollisionAlgorithmConstructionInfo& info, const btCollisionObjectWrapper* first,
                      const btCollisionObjectWrapper* second);
  void processCollision(const btCollisionObjectWrapper* first, const btCollisionObjectWrapper* second,
                        const btDispatcherInfo& info, btManifoldResult* result) override;

 private:
  btGjkEpaPenetrationDepthSolver solver_;
  btConvexConvexAlgorithm bullet_;
};

/// Bullet's own algorithm for a sphere and the ground, on a manifold that can be read.
class SphereGroundAlgorithm final : public ManifoldAlgorithm {
 public:
  SphereGroundAlgorithm(const btCollisionAlgorithmConstructionInfo& info, const btCollisionObjectWrapper* first,
                        const btCollisionObjectWrapper* second, bool plane_first);
  void processCollision(const btCollisionObjectWrapper* first, const btCollisionObjectWrapper* second,
                        const btDispatcherInfo& info, btManifoldResult* result) override;

 private:
  btConvexPlaneCollisionAlgorithm bullet_;
};

}  // namespace griffith::contact
