#pragma once

// Private to sim/contact.

#include <btBulletCollisionCommon.h>

#include <vector>

namespace griffith::contact {

/// Bullet's dispatcher, which looks at pairs of hulls side by side: what it finds is noted one after the other.
class Dispatcher final : public btCollisionDispatcher {
 public:
  explicit Dispatcher(btCollisionConfiguration* configuration);
  void dispatchAllCollisionPairs(btOverlappingPairCache* pairs, const btDispatcherInfo& info,
                                 btDispatcher* dispatcher) override;

 private:
  static void take_pair(btBroadphasePair& pair, btCollisionDispatcher& dispatcher, const btDispatcherInfo& info);

  std::vector<btBroadphasePair*> hull_pairs_;
};

}  // namespace griffith::contact
