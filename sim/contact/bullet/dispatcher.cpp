#include "sim/contact/bullet/dispatcher.h"

#include <BulletCollision/CollisionDispatch/btCollisionObjectWrapper.h>

#include "sim/contact/bullet/hull_contact.h"
#include "sim/core/parallel.h"

namespace griffith::contact {
namespace {

/// The two sides of a pair as Bullet's algorithms see them.
struct Sides {
  explicit Sides(const btBroadphasePair& pair) : first(wrapped(pair.m_pProxy0)), second(wrapped(pair.m_pProxy1)) {}
  bool are_hulls() const {
    return first.getCollisionShape()->getShapeType() == CONVEX_HULL_SHAPE_PROXYTYPE &&
           second.getCollisionShape()->getShapeType() == CONVEX_HULL_SHAPE_PROXYTYPE;
  }

  btCollisionObjectWrapper first, second;

 private:
  static btCollisionObjectWrapper wrapped(const btBroadphaseProxy* proxy) {
    const auto* object = static_cast<const btCollisionObject*>(proxy->m_clientObject);
    return {nullptr, object->getCollisionShape(), object, object->getWorldTransform(), -1, -1};
  }
};

HullHullAlgorithm& algorithm_of(const btBroadphasePair& pair) {
  return *static_cast<HullHullAlgorithm*>(pair.m_algorithm);
}

}  // namespace

Dispatcher::Dispatcher(btCollisionConfiguration* configuration) : btCollisionDispatcher(configuration) {
  setNearCallback(take_pair);
}

void Dispatcher::take_pair(btBroadphasePair& pair, btCollisionDispatcher& dispatcher, const btDispatcherInfo& info) {
  const Sides sides(pair);
  if (!sides.are_hulls()) return defaultNearCallback(pair, dispatcher, info);
  if (!dispatcher.needsCollision(sides.first.getCollisionObject(), sides.second.getCollisionObject())) return;
  if (!pair.m_algorithm)
    pair.m_algorithm = dispatcher.findAlgorithm(&sides.first, &sides.second, nullptr, BT_CONTACT_POINT_ALGORITHMS);
  static_cast<Dispatcher&>(dispatcher).hull_pairs_.push_back(&pair);
}

void Dispatcher::dispatchAllCollisionPairs(btOverlappingPairCache* pairs, const btDispatcherInfo& info,
                                           btDispatcher* dispatcher) {
  constexpr int kPairsAtOnce = 32;
  hull_pairs_.clear();
  btCollisionDispatcher::dispatchAllCollisionPairs(pairs, info, dispatcher);
  parallel_for(static_cast<int>(hull_pairs_.size()), kPairsAtOnce, [&](int begin, int end) {
    for (int i = begin; i < end; ++i) {
      const Sides sides(*hull_pairs_[i]);
      algorithm_of(*hull_pairs_[i]).find(placed_hull(sides.first), placed_hull(sides.second));
    }
  });
  for (btBroadphasePair* pair : hull_pairs_) {
    const Sides sides(*pair);
    btManifoldResult result(&sides.first, &sides.second);
    algorithm_of(*pair).note(placed_hull(sides.second), result);
  }
}

PairMemories Dispatcher::memories() const {
  PairMemories all = remembered_;
  for (const PairAlgorithm* algorithm : algorithms_)
    if (!algorithm->is_retired()) all.emplace(algorithm->key(), algorithm->memory());
  return all;
}

void Dispatcher::restore(PairMemories memories, const std::function<const btCollisionObject*(int)>& object) {
  remembered_ = std::move(memories);
  for (auto& [key, memory] : remembered_) {
    if (!memory.manifold) continue;
    memory.manifold = std::make_shared<btPersistentManifold>(*memory.manifold);  // the other world has its own
    memory.manifold->setBodies(object(memory.manifold->getBody0()->getUserIndex()),
                               object(memory.manifold->getBody1()->getUserIndex()));
  }
}

void Dispatcher::forget_if(const std::function<bool(const PairKey&)>& gone) {
  std::erase_if(remembered_, [&](const auto& entry) { return gone(entry.first); });
}

std::optional<PairMemory> Dispatcher::take_memory(const PairKey& key) {
  const auto found = remembered_.find(key);
  if (found == remembered_.end()) return {};
  PairMemory memory = std::move(found->second);
  remembered_.erase(found);
  return memory;
}

}  // namespace griffith::contact
