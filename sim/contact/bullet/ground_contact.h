#pragma once

// Private to sim/contact.

#include "sim/contact/bullet/pair.h"

namespace griffith::contact {

/// Contacts of a hull with a plane: every corner near the plane at once, where Bullet's own algorithm finds one a step.
class HullGroundAlgorithm final : public ManifoldAlgorithm {
 public:
  HullGroundAlgorithm(const btCollisionAlgorithmConstructionInfo& info, const btCollisionObjectWrapper* first,
                      const btCollisionObjectWrapper* second, bool plane_first);
  void processCollision(const btCollisionObjectWrapper* first, const btCollisionObjectWrapper* second,
                        const btDispatcherInfo&, btManifoldResult* result) override;

 private:
  bool plane_first_;
};

}  // namespace griffith::contact
