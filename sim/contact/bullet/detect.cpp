#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <tuple>

#include "sim/contact/bullet/contact_world.h"
#include "sim/contact/contact_reduction.h"

namespace griffith {

using namespace contact;

namespace {

bool pair_less(const Allowance& left, const Allowance& right) {
  return std::tie(left.a, left.b) < std::tie(right.a, right.b);
}

/// True for two kinematic objects of which one is new, has just moved or is pushed by something kinematic. One that
/// stands still otherwise loads its supports.
bool may_push_kinematic(const Object& a, const Object& b) {
  const auto may_push = [](const Object& object) { return object.fresh || object.active || object.carried; };
  return (may_push(a) || may_push(b)) && !a.asleep && !b.asleep;
}

}  // namespace

Contact contact::contact_at(const Pair& pair, const Manifold& manifold, const Manifold::Point& point, const Place& a,
                            const Place& b) {
  const Vec3 on_a = a.to_world(point.on_a), on_b = b.to_world(point.on_b), normal = b.rotation * manifold.normal_in_b;
  return {ProxyId(pair.a), ProxyId(pair.b), 0.5 * (on_a + on_b), normal, normal.dot(on_a - on_b)};
}

bool ContactWorld::Impl::all_at_rest() const {
  return std::none_of(objects.begin(), objects.end(), [](const Object& object) {
    return object.exists && (object.fresh || object.active || (object.carried && !object.asleep));
  });
}

void ContactWorld::Impl::detect(double dt) {
  for (Object& object : objects) {
    object.first_velocity = object.state.velocity;
    object.first_spin = object.state.angular_velocity;
  }
  past_node_contacts.swap(node_contacts);
  std::ranges::sort(past_node_contacts, std::ranges::less(), &NodeContact::key);
  node_contacts.clear();
  contacts.clear();
  memories.clear();
  elastic_contacts.clear();
  if (all_at_rest()) return;
  update_pairs(update_boxes(dt));
  compact_manifolds();
  find_points(dt);
  update_allowances();
  wake_disturbed(dt);
  list_contacts(dt);
  for (Object& object : objects) object.fresh = false;
}

void ContactWorld::Impl::update_allowances() {
  if (allowances.empty() && std::ranges::none_of(objects, [](const Object& object) { return object.fresh; })) return;
  std::vector<Allowance> overlaps;  // one per pair of objects: their parts are neighbors
  for (const Pair& pair : pairs) {
    if (pair.count == 0) continue;
    const Object &a = objects[pair.a], &b = objects[pair.b];
    const Manifold& manifold = manifolds[pair.manifold];
    for (const Manifold::Point& point : manifold.listed()) {
      const double overlap = -contact_at(pair, manifold, point, a.place, b.place).distance;
      if (!(overlap > 0)) continue;
      const ProxyId first(pair.a), second(pair.b);
      if (overlaps.empty() || overlaps.back().a != first || overlaps.back().b != second)
        overlaps.push_back({first, second, 0});
      overlaps.back().overlap = std::max(overlaps.back().overlap, overlap);
    }
  }
  std::erase_if(overlaps, [&](Allowance& pair) {
    const Object &a = objects[pair.a], &b = objects[pair.b];
    const bool are_fresh_pieces = a.fresh && a.parted && b.fresh && b.parted;
    if (!are_fresh_pieces) pair.overlap = std::min(pair.overlap, allowance(pair.a, pair.b));
    return pair.overlap == 0;
  });
  allowances = std::move(overlaps);
}

double ContactWorld::Impl::allowance(ProxyId a, ProxyId b) const {
  const Allowance wanted{a, b, 0};
  const auto found = std::lower_bound(allowances.begin(), allowances.end(), wanted, pair_less);
  return found != allowances.end() && found->a == a && found->b == b ? found->overlap : 0;
}

void ContactWorld::Impl::list_contacts(double dt) {
  scratch.unlisted.assign(objects.size(), false);
  scratch.is_solved = false;
  for (auto first = pairs.begin(); first != pairs.end();) {
    const auto end = std::find_if_not(first, pairs.end(),
                                      [&](const Pair& pair) { return pair.a == first->a && pair.b == first->b; });
    const Object &a = objects[first->a], &b = objects[first->b];
    if (a.moves() || b.moves() || may_push_kinematic(a, b)) list_pair({first, end}, dt);
    first = end;
  }
}

/// Drops the contacts from `first` on, of one pair, that overlap against one another. Pieces of jagged outlines have
/// convex parts that overlap where they fit together. The shortest ways out of such overlaps lie on both sides:
/// together they would clamp the pieces by forces that nothing limits.
void ContactWorld::Impl::drop_opposing_overlaps(std::size_t first) {
  constexpr double kOpposing = -0.7;  // cosine of the angle between normals
  const std::span<const Contact> listed = std::span(contacts).subspan(first);
  if (listed.empty() || allowance(listed.front().a, listed.front().b) == 0) return;
  const auto opposes = [&](const Contact& one, const Contact& other) {
    return other.distance < 0 && one.normal.dot(other.normal) < kOpposing;
  };
  std::vector<bool> drops(listed.size());
  for (std::size_t i = 0; i < listed.size(); ++i)
    drops[i] = listed[i].distance < 0 &&
               std::ranges::any_of(listed, [&](const Contact& other) { return opposes(listed[i], other); });
  drop_contacts(first, drops);
}

/// Drops the contacts from `first` on for which `drops` is true; their points carry nothing any more.
void ContactWorld::Impl::drop_contacts(std::size_t first, const std::vector<bool>& drops) {
  std::size_t end = first;
  for (std::size_t i = first; i < contacts.size(); ++i) {
    if (drops[i - first]) {
      remember_force(memories[i], Vec3::Zero());
      continue;
    }
    contacts[end] = contacts[i];
    memories[end++] = memories[i];
  }
  contacts.resize(end);
  memories.resize(end);
}

/// Lists the points that are near, or come near within `dt` [s], at most four with much the same normal.
void ContactWorld::Impl::list_pair(std::span<const Pair> of_pair, double dt) {
  const std::size_t first = contacts.size();
  const Object &a = objects[of_pair.front().a], &b = objects[of_pair.front().b];
  for (const Pair& pair : of_pair) {
    if (pair.count == 0) continue;
    Manifold& manifold = manifolds[pair.manifold];
    std::array<Contact, 4> found;
    double overlap = 0;  // pushing a corner out by it may push another one in
    for (int i = 0; i < pair.count; ++i) {
      found[i] = contact_at(pair, manifold, manifold.points[i], a.place, b.place);
      overlap = std::max(overlap, -found[i].distance);
    }
    for (int i = 0; i < pair.count; ++i) {
      const Contact& contact = found[i];
      const Nearness nearness = contact.distance < overlap ? Nearness::near : nearness_of(pair, contact, dt);
      if (nearness != Nearness::near) {
        manifold.points[i].force.setZero();
        if (nearness == Nearness::left_out) scratch.unlisted[pair.a] = scratch.unlisted[pair.b] = true;
        continue;
      }
      contacts.push_back(contact);
      memories.push_back({pair.manifold, i});
    }
  }
  if (of_pair.size() == 1) return;
  drop_opposing_overlaps(first);
  if (contacts.size() - first <= 4) return;
  std::vector<bool> drops(contacts.size() - first, true);
  const double allowed = allowance(ProxyId(of_pair.front().a), ProxyId(of_pair.front().b));
  for (const int kept : representative_contacts(std::span(contacts).subspan(first), allowed)) drops[kept] = false;
  drop_contacts(first, drops);
}

/// Returns the speed at which a gap closes, even if something stops one of the two objects [m/s].
double ContactWorld::Impl::closing_speed(const Pair& pair, const Contact& contact) const {
  const auto speed_along = [&](const Object& object) {
    const RigidState& state = object.state;
    const Vec3 arm = contact.position - state.pose.translation;
    return contact.normal.dot(state.velocity + state.angular_velocity.cross(arm));
  };
  const double of_a = -speed_along(objects[pair.a]), of_b = speed_along(objects[pair.b]);
  return std::max({of_a + of_b, of_a, of_b});
}

/// Returns `near` for a gap that is small or closes within `dt` [s]. Approaches that could cause damage are left out:
/// the owner predicts these itself, and sweeps what moves freely.
ContactWorld::Impl::Nearness ContactWorld::Impl::nearness_of(const Pair& pair, const Contact& contact,
                                                             double dt) const {
  const Object &a = objects[pair.a], &b = objects[pair.b];
  if (contact.distance < reach(a, b, 0)) return Nearness::near;
  const double speed = closing_speed(pair, contact);
  if (contact.distance >= dt * with_fall(speed, dt)) return Nearness::away;
  const bool is_swept = a.moves() || b.moves();
  return !is_swept || speed < std::min(a.impact_speed, b.impact_speed) ? Nearness::near : Nearness::left_out;
}

void ContactWorld::Impl::replace_contacts(const std::vector<bool>& taken_out, std::span<const Contact> put_in) {
  assert(taken_out.size() == contacts.size());
  drop_contacts(0, taken_out);
  for (const Contact& contact : put_in) {
    NodeContact added{contact.a, contact.b, contact.node_a, contact.node_b, contact.position};
    const auto past = std::ranges::lower_bound(past_node_contacts, added.key(), std::ranges::less(), &NodeContact::key);
    if (past != past_node_contacts.end() && past->key() == added.key()) added.force = past->force;
    contacts.push_back(contact);
    memories.push_back({-1, 0, static_cast<int>(node_contacts.size())});
    node_contacts.push_back(added);
  }
}

Vec3 ContactWorld::Impl::remembered_force(const Memory& memory) const {
  if (memory.manifold < 0) return node_contacts[memory.node_contact].force;
  return manifolds[memory.manifold].points[memory.point].force;
}

void ContactWorld::Impl::remember_force(const Memory& memory, const Vec3& force) {
  (memory.manifold < 0 ? node_contacts[memory.node_contact].force
                       : manifolds[memory.manifold].points[memory.point].force) = force;
}

}  // namespace griffith
