#include "sim/contact/bullet/pair.h"

#include "sim/contact/bullet/dispatcher.h"

namespace griffith::contact {

PairAlgorithm::PairAlgorithm(const btCollisionAlgorithmConstructionInfo& info, const btCollisionObjectWrapper* first,
                             const btCollisionObjectWrapper* second)
    : btCollisionAlgorithm(info),
      first_(first->getCollisionObject()),
      second_(second->getCollisionObject()),
      key_{first_->getUserIndex(), first->m_index, second_->getUserIndex(), second->m_index} {
  dispatcher().enter(*this);
}

PairAlgorithm::~PairAlgorithm() {
  dispatcher().leave(*this);
  release_manifold();
}

Dispatcher& PairAlgorithm::dispatcher() const { return *static_cast<Dispatcher*>(m_dispatcher); }

PairMemory PairAlgorithm::memory() const {
  PairMemory memory;
  if (manifold_ && manifold_->getNumContacts() > 0)
    memory.manifold = std::make_shared<btPersistentManifold>(*manifold_);
  return memory;
}

std::optional<PairMemory> PairAlgorithm::take_memory() {
  std::optional<PairMemory> memory = dispatcher().take_memory(key_);
  if (!memory || !memory->manifold) return memory;
  make_manifold();
  for (int i = 0; i < memory->manifold->getNumContacts(); ++i)
    manifold_->addManifoldPoint(memory->manifold->getContactPoint(i));
  // Compounds refresh all that their parts have before they look at the first.
  if (key_.first_part >= 0 || key_.second_part >= 0)
    manifold_->refreshContactPoints(manifold_->getBody0()->getWorldTransform(),
                                    manifold_->getBody1()->getWorldTransform());
  return memory;
}

void PairAlgorithm::make_manifold() { manifold_ = m_dispatcher->getNewManifold(first_, second_); }

void PairAlgorithm::release_manifold() {
  if (manifold_) m_dispatcher->releaseManifold(manifold_);
  manifold_ = nullptr;
}

}  // namespace griffith::contact
