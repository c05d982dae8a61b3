#pragma once

// Private to sim/contact.

#include <btBulletCollisionCommon.h>

namespace griffith::contact {

/// Contacts of two hulls: all corners of the area where they meet at once, where Bullet's own algorithm finds one point
/// a step. So a face that strikes a face does not turn it, and stacks stand.
class HullHullAlgorithm final : public btCollisionAlgorithm {
 public:
  HullHullAlgorithm(const btCollisionAlgorithmConstructionInfo& info, const btCollisionObjectWrapper* first,
                    const btCollisionObjectWrapper* second);
  ~HullHullAlgorithm() override;
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
