#include "sim/world/contact_views.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <tuple>
#include <utility>

namespace griffith {
namespace {

/// Returns the cell of a contact, half an element in size: contacts in one cell are shown as one.
std::array<std::int64_t, 3> contact_cell(const WorldState& world, const ContactView& contact) {
  const BodyId body = contact.a.valid() ? contact.a : contact.b;
  if (!body.valid()) return {};
  const Vec3 place = contact.position / (0.5 * world.bodies[body].element_size);
  constexpr double kFarthest = 1e15;
  std::array<std::int64_t, 3> cell;
  for (int i = 0; i < 3; ++i) cell[i] = std::llround(std::clamp(place[i], -kFarthest, kFarthest));
  return cell;
}

}  // namespace

void add_contacts(const WorldState& world, std::vector<ContactView>& views) {
  for (const Contact& contact : world.contact_world.contacts()) {
    if (contact.impulse.isZero(0)) continue;
    views.push_back(
        {world.body_of(contact.a), world.body_of(contact.b), contact.position, contact.normal, contact.impulse});
  }
}

void merge(ContactView& contact, const ContactView& other) {
  const double weight = contact.impulse.norm(), other_weight = other.impulse.norm(), sum = weight + other_weight;
  contact.position = (weight * contact.position + other_weight * other.position) / sum;
  contact.normal = (weight * contact.normal + other_weight * other.normal).normalized();
  contact.impulse += other.impulse;
}

std::vector<ContactView> merged_contacts(const WorldState& world, std::span<const ContactView> views) {
  using Key = std::tuple<BodyId, BodyId, std::array<std::int64_t, 3>>;
  std::vector<std::pair<Key, ContactView>> contacts;
  for (const ContactView& contact : views)
    contacts.emplace_back(Key(contact.a, contact.b, contact_cell(world, contact)), contact);
  std::ranges::stable_sort(contacts, {}, &std::pair<Key, ContactView>::first);
  std::vector<ContactView> merged;
  for (std::size_t i = 0; i < contacts.size(); ++i) {
    if (i > 0 && contacts[i].first == contacts[i - 1].first) {
      merge(merged.back(), contacts[i].second);
    } else {
      merged.push_back(contacts[i].second);
    }
  }
  return merged;
}

}  // namespace griffith
