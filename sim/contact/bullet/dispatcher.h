#pragma once

// Private to sim/contact.

#include <btBulletCollisionCommon.h>

#include <functional>
#include <optional>
#include <unordered_set>
#include <vector>

#include "sim/contact/bullet/pair.h"

namespace griffith::contact {

/// Bullet's dispatcher, which looks at pairs of hulls side by side: what it finds is noted one after the other. Knows
/// what its algorithms remember, so that a world can be copied. In the copy, Bullet makes the algorithm of a pair when
/// it next looks at it: until then what is remembered of the pair stands here, that sleepers touch above all.
class Dispatcher final : public btCollisionDispatcher {
 public:
  explicit Dispatcher(btCollisionConfiguration* configuration);
  void dispatchAllCollisionPairs(btOverlappingPairCache* pairs, const btDispatcherInfo& info,
                                 btDispatcher* dispatcher) override;

  /// Memories of all algorithms, and of those that are yet to be made.
  PairMemories memories() const;
  /// Takes the memories of another world. `object`: this world's, of an index.
  void restore(PairMemories memories, const std::function<const btCollisionObject*(int)>& object);
  /// Drops what stands here for which this holds.
  void forget_if(const std::function<bool(const PairKey&)>& gone);
  /// How many pairs of parts are near each other.
  std::size_t pair_count() const { return algorithms_.size() + remembered_.size(); }
  /// Calls visit(manifold) for all that have points.
  template <class Visit>
  void visit_touching(Visit visit) {
    const auto look = [&](btPersistentManifold* manifold) {
      if (manifold->getNumContacts() > 0) visit(manifold);
    };
    for (int i = 0; i < getNumManifolds(); ++i) look(getManifoldByIndexInternal(i));
    for (auto& [key, memory] : remembered_)
      if (memory.manifold) look(memory.manifold.get());
  }

  // For PairAlgorithm.
  void enter(const PairAlgorithm& algorithm) { algorithms_.insert(&algorithm); }
  void leave(const PairAlgorithm& algorithm) { algorithms_.erase(&algorithm); }
  std::optional<PairMemory> take_memory(const PairKey& key);

 private:
  static void take_pair(btBroadphasePair& pair, btCollisionDispatcher& dispatcher, const btDispatcherInfo& info);

  std::vector<btBroadphasePair*> hull_pairs_;
  std::unordered_set<const PairAlgorithm*> algorithms_;
  PairMemories remembered_;
};

}  // namespace griffith::contact
