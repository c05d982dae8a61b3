#include "sim/contact/bullet/contact_world.h"
#include "sim/core/hash_bytes.h"

namespace griffith {

using namespace contact;

namespace {

static_assert(sizeof(Contact) == 11 * sizeof(double) + 4 * sizeof(NodeId), "it has no padding");
static_assert(sizeof(NodeContact) == 3 * sizeof(double) + 4 * sizeof(NodeId), "it has no padding");
static_assert(sizeof(Allowance) == sizeof(double) + 2 * sizeof(ProxyId), "it has no padding");

std::uint64_t hash_of_rest(const Object& object, std::uint64_t seed) {
  const Vec3& place = object.resting_place.translation;
  const std::array<double, 7> values = {place.x(),
                                        place.y(),
                                        place.z(),
                                        object.still_time,
                                        object.dissipated,
                                        object.impact_speed,
                                        object.asleep ? 1.0 : 0.0};
  return hash_values(std::span<const double>(values), seed);
}

}  // namespace

std::uint64_t ContactWorld::memory_hash() const {
  std::uint64_t hash = hash_values(impl_->contacts);
  hash = hash_values(impl_->node_contacts, hash);
  hash = hash_values(impl_->allowances, hash);
  for (const Object& object : impl_->objects)
    if (object.exists) hash = hash_of_rest(object, hash);
  return hash;
}

}  // namespace griffith
