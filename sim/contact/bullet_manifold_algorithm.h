#pragma once

// Private to sim/contact.

#include <BulletCollision/CollisionDispatch/btCollisionObjectWrapper.h>
#include <btBulletCollisionCommon.h>

namespace griffith::contact {

/// An algorithm with one manifold for as long as its pair is near.
class ManifoldAlgorithm : public btCollisionAlgorithm {
 public:
  ManifoldAlgorithm(const btCollisionAlgorithmConstructionInfo& info, const btCollisionObjectWrapper* first,
                    const btCollisionObjectWrapper* second)
      : btCollisionAlgorithm(info),
        manifold_(info.m_dispatcher1->getNewManifold(first->getCollisionObject(), second->getCollisionObject())) {}
  ~ManifoldAlgorithm() override { m_dispatcher->releaseManifold(manifold_); }
  btScalar calculateTimeOfImpact(btCollisionObject*, btCollisionObject*, const btDispatcherInfo&,
                                 btManifoldResult*) override {
    return 1;
  }
  void getAllContactManifolds(btManifoldArray& manifolds) override { manifolds.push_back(manifold_); }

 protected:
  btPersistentManifold* manifold_;
};

}  // namespace griffith::contact
