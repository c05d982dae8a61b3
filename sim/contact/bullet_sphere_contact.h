#pragma once

// Private to sim/contact.

#include "sim/contact/bullet_manifold_algorithm.h"

namespace griffith::contact {

/// The contact of two spheres in closed form, from within reach to one inside the other. Bullet's own algorithm for two
/// spheres sees them when they overlap only, its general one takes a thousand times as long where they overlap by far.
class SphereSphereAlgorithm final : public ManifoldAlgorithm {
 public:
  using ManifoldAlgorithm::ManifoldAlgorithm;
  void processCollision(const btCollisionObjectWrapper* first, const btCollisionObjectWrapper* second,
                        const btDispatcherInfo&, btManifoldResult* result) override;

  struct Factory final : btCollisionAlgorithmCreateFunc {
    btCollisionAlgorithm* CreateCollisionAlgorithm(btCollisionAlgorithmConstructionInfo& info,
                                                   const btCollisionObjectWrapper* first,
                                                   const btCollisionObjectWrapper* second) override;
  };
};

}  // namespace griffith::contact
