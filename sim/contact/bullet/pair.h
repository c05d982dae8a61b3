#pragma once

// Private to sim/contact.

#include <BulletCollision/CollisionDispatch/btCollisionObjectWrapper.h>
#include <btBulletCollisionCommon.h>

#include <compare>
#include <map>
#include <memory>
#include <optional>
#include <type_traits>

#include "sim/core/linear_algebra.h"

namespace griffith::contact {

class Dispatcher;

/// The index of an object that is gone.
inline constexpr int kRetired = -1;

/// Names two parts that are near each other, in the order in which their algorithm sees them.
struct PairKey {
  int first, first_part, second, second_part;  ///< index of the object; of its part, -1 where it is of one
  auto operator<=>(const PairKey&) const = default;
};

/// What an algorithm remembers of two parts from one detection to the next.
struct PairMemory {
  std::shared_ptr<btPersistentManifold> manifold;  ///< null where they do not touch
  // Of two hulls, as in HullHullAlgorithm:
  Vec3 parting_direction = Vec3::Zero();
  btTransform seen_from_b = btTransform::getIdentity();
  btVector3 normal_in_b = btVector3(0, 0, 0);
};

using PairMemories = std::map<PairKey, PairMemory>;

/// An algorithm for two parts whose memory can be read. In the copy of a world it starts from the memory that its pair
/// had there.
class PairAlgorithm : public btCollisionAlgorithm {
 public:
  PairAlgorithm(const btCollisionAlgorithmConstructionInfo& info, const btCollisionObjectWrapper* first,
                const btCollisionObjectWrapper* second);
  ~PairAlgorithm() override;
  PairAlgorithm(const PairAlgorithm&) = delete;
  PairAlgorithm& operator=(const PairAlgorithm&) = delete;

  const PairKey& key() const { return key_; }
  virtual PairMemory memory() const;
  /// Whether an object of the pair is gone.
  bool is_retired() const { return first_->getUserIndex() == kRetired || second_->getUserIndex() == kRetired; }
  btScalar calculateTimeOfImpact(btCollisionObject*, btCollisionObject*, const btDispatcherInfo&,
                                 btManifoldResult*) override {
    return 1;
  }
  void getAllContactManifolds(btManifoldArray& manifolds) override {
    if (manifold_) manifolds.push_back(manifold_);
  }

 protected:
  /// What is remembered of the pair, in a copied world, the first time; its points are in the manifold then.
  std::optional<PairMemory> take_memory();
  void make_manifold();
  void release_manifold();

  btPersistentManifold* manifold_ = nullptr;

 private:
  Dispatcher& dispatcher() const;

  const btCollisionObject *first_, *second_;  // in an order that may differ from that of a compound's pair
  PairKey key_;
};

/// Makes algorithms in Bullet's memory: Algorithm(info, first, second), or with `m_swapped` as a fourth argument, which
/// tells those for a plane that it comes first.
template <class Algorithm>
struct AlgorithmFactory final : btCollisionAlgorithmCreateFunc {
  btCollisionAlgorithm* CreateCollisionAlgorithm(btCollisionAlgorithmConstructionInfo& info,
                                                 const btCollisionObjectWrapper* first,
                                                 const btCollisionObjectWrapper* second) override {
    using Wrapper = const btCollisionObjectWrapper*;
    void* memory = info.m_dispatcher1->allocateCollisionAlgorithm(sizeof(Algorithm));
    if constexpr (std::is_constructible_v<Algorithm, decltype(info), Wrapper, Wrapper, bool>)
      return new (memory) Algorithm(info, first, second, m_swapped);
    else
      return new (memory) Algorithm(info, first, second);
  }
};

/// An algorithm with one manifold for as long as its pair is near.
class ManifoldAlgorithm : public PairAlgorithm {
 public:
  ManifoldAlgorithm(const btCollisionAlgorithmConstructionInfo& info, const btCollisionObjectWrapper* first,
                    const btCollisionObjectWrapper* second)
      : PairAlgorithm(info, first, second) {
    if (!take_memory() || !manifold_) make_manifold();
  }
};

}  // namespace griffith::contact
