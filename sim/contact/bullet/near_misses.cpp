#include <algorithm>
#include <cassert>

#include "sim/contact/bullet/contact_world.h"

namespace griffith {

using namespace contact;

std::vector<int> ContactWorld::Impl::drop_near_misses(double dt, std::span<const double> approach) {
  assert(approach.size() == contacts.size());
  constexpr double kSafety = 1.25, kPassedOn = 0.5;
  // Speeds that one impact could pass on toward the next neighbor.
  std::vector<double> struck(objects.size(), 0.0);
  for (std::size_t i = 0; i < contacts.size(); ++i)
    if (approach[i] * dt > contacts[i].distance)
      for (ProxyId side : {contacts[i].a, contacts[i].b})
        if (objects[side].is_free()) struck[side] = std::max(struck[side], approach[i]);
  const auto may_push = [&](std::size_t i) {
    const Contact& contact = contacts[i];
    const double speed =
        std::max({approach[i], kPassedOn * struck[contact.a], kPassedOn * struck[contact.b]}) + gravity.norm() * dt;
    return contact.distance <= kSafety * speed * dt || contact.normal.dot(remembered_force(memories[i])) > 0;
  };
  std::vector<int> index(contacts.size(), -1);
  std::size_t kept = 0;
  for (std::size_t i = 0; i < contacts.size(); ++i) {
    if (!may_push(i)) continue;
    index[i] = static_cast<int>(kept);
    contacts[kept] = contacts[i];
    memories[kept++] = memories[i];
  }
  contacts.resize(kept);
  memories.resize(kept);
  return index;
}

void ContactWorld::Impl::drop_contacts_of(const std::vector<bool>& dropped) {
  const auto is_dropped = [&](ProxyId id) { return static_cast<std::size_t>(id) < dropped.size() && dropped[id]; };
  std::size_t kept = 0;
  for (std::size_t i = 0; i < contacts.size(); ++i) {
    if (is_dropped(contacts[i].a) || is_dropped(contacts[i].b)) continue;
    contacts[kept] = contacts[i];
    memories[kept++] = memories[i];
  }
  contacts.resize(kept);
  memories.resize(kept);
}

}  // namespace griffith
