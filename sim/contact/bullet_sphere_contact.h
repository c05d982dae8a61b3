#pragma once

// Private to sim/contact.

#include <btBulletCollisionCommon.h>

namespace griffith::contact {

/// The contact of two spheres in closed form, from within reach to one inside the other. Bullet's own algorithm for two
/// spheres sees them when they overlap only, its general one takes a thousand times as long where they overlap by far.
class SphereSphereAlgorithm final : public btCollisionAlgorithm {
 public:
  SphereSphereAlgorithm(const btCollisionAlgorithmConstructionInfo& info, const btCollisionObjectWrapper* first,
                        const btCollisionObjectWrapper* second);
  ~SphereSphereAlgorithm() override;
  void processCollision(const btCollisionObjectWrapper* first, const btCollisionObjectWrapper* second,
                        const btDispatcherInfo&, btManifoldResult* result) override;
  btScalar calculateTimeOfImpact(btCollisionObject*, btCollisionObject*, const btDispatcherInfo&,
                                 btManifoldResult*) override {
    return 1;
  }
  void getAllContactManifolds(btManifoldArray& manifolds) override { manifolds.push_back(manifold_); }

  struct Factory final : btCollisionAlgorithmCreateFunc {
    btCollisionAlgorithm* CreateCollisionAlgorithm(btCollisionAlgorithmConstructionInfo& info,
                                                   const btCollisionObjectWrapper* first,
                                                   const btCollisionObjectWrapper* second) override;
  };

 private:
  btPersistentManifold* manifold_;
};

}  // namespace griffith::contact
