#include <algorithm>
#include <cmath>

#include "sim/contact/bullet/contact_world.h"
#include "sim/core/dense_algebra.h"
#include "sim/core/hash_bytes.h"
#include "sim/core/sort_unique.h"

namespace griffith {

using namespace contact;

namespace {

static_assert(sizeof(Contact) == 15 * sizeof(double) + 4 * sizeof(NodeId), "it has no padding");
static_assert(sizeof(NodeContact) == 6 * sizeof(double) + 4 * sizeof(NodeId), "it has no padding");
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

/// Force on the first of two objects, and its torque about a place.
struct PairForce {
  Vec3 place = Vec3::Zero(), force = Vec3::Zero(), torque = Vec3::Zero();

  /// Adds what the owner's contacts of `a` with `b` carried; `side`: 1 where a is the first.
  void add(std::span<const NodeContact> past, ProxyId a, ProxyId b, double side) {
    const auto pair_of = [](const NodeContact& contact) { return std::pair(contact.a, contact.b); };
    for (const NodeContact& contact : std::ranges::equal_range(past, std::pair(a, b), std::ranges::less(), pair_of)) {
      force += side * contact.force;
      torque += (contact.position - place).cross(side * contact.force);
    }
  }
};

/// Returns normal forces of contacts, one each, that best approximate the given force and torque; the smallest ones of
/// these [N].
Eigen::VectorXd normal_forces(std::span<const Contact> contacts, const PairForce& carried) {
  const auto count = static_cast<Eigen::Index>(contacts.size());
  double extent = 0;
  for (const Contact& contact : contacts) extent = std::max(extent, (contact.position - carried.place).norm());
  const double per_length = extent > 0 ? 1 / extent : 0;
  Eigen::Matrix<double, 6, Eigen::Dynamic> wrenches(6, count);
  for (Eigen::Index i = 0; i < count; ++i) {
    const Contact& contact = contacts[i];
    wrenches.col(i) << contact.normal, per_length * (contact.position - carried.place).cross(contact.normal);
  }
  Eigen::Vector<double, 6> wanted;
  wanted << carried.force, per_length * carried.torque;
  return least_squares(wrenches, wanted).cwiseMax(0);
}

}  // namespace

/// Passes the forces of the owner's contacts of a pair in the last substep on to its points, if the pair has no such
/// contacts any more and its points carried nothing: a body that becomes rigid stays at rest.
void ContactWorld::Impl::inherit_forces() {
  if (past_node_contacts.empty()) return;
  const auto pair_of = [](const auto& contact) { return std::minmax({contact.a, contact.b}); };
  std::vector<std::pair<ProxyId, ProxyId>> followed;
  for (const NodeContact& contact : node_contacts) followed.push_back(pair_of(contact));
  sort_unique(followed);
  for (std::size_t first = 0, end = 0; first < contacts.size(); first = end) {
    while (end < contacts.size() && pair_of(contacts[end]) == pair_of(contacts[first])) ++end;
    if (!std::ranges::binary_search(followed, pair_of(contacts[first]))) inherit_forces(first, end);
  }
}

void ContactWorld::Impl::inherit_forces(std::size_t first, std::size_t end) {
  for (std::size_t i = first; i < end; ++i)
    if (!remembered_force(memories[i]).isZero(0)) return;
  const std::span<const Contact> listed = std::span(contacts).subspan(first, end - first);
  PairForce carried;
  for (const Contact& contact : listed) carried.place += contact.position / static_cast<double>(listed.size());
  carried.add(past_node_contacts, listed.front().a, listed.front().b, 1);
  carried.add(past_node_contacts, listed.front().b, listed.front().a, -1);
  if (carried.force.isZero(0)) return;
  const Eigen::VectorXd normal = normal_forces(listed, carried);
  if (!(normal.sum() > 0)) return;
  Vec3 beside = carried.force;
  for (std::size_t i = 0; i < listed.size(); ++i) beside -= normal[i] * listed[i].normal;
  for (std::size_t i = 0; i < listed.size(); ++i)
    remember_force(memories[first + i], normal[i] * (listed[i].normal + beside / normal.sum()));
}

std::uint64_t ContactWorld::memory_hash() const {
  std::uint64_t hash = hash_values(impl_->contacts);
  hash = hash_values(impl_->node_contacts, hash);
  hash = hash_values(impl_->allowances, hash);
  for (const Object& object : impl_->objects)
    if (object.exists) hash = hash_of_rest(object, hash);
  return hash;
}

}  // namespace griffith
