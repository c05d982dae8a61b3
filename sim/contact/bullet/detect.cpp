#include <algorithm>
#include <cassert>
#include <tuple>

#include "sim/contact/bullet/contact_world.h"
#include "sim/contact/contact_reduction.h"

namespace griffith {

using namespace contact;

namespace {

ProxyId id_of(const btCollisionObject* object) { return ProxyId(object->getUserIndex()); }

/// Names a manifold whatever the order in which pairs were found: the objects and the parts of compounds that touch.
auto order_of(const btPersistentManifold* manifold) {
  const btManifoldPoint& point = manifold->getContactPoint(0);
  return std::tuple(manifold->getBody0()->getUserIndex(), manifold->getBody1()->getUserIndex(), point.m_index0,
                    point.m_index1);
}

double largest_overlap(const btPersistentManifold& manifold) {
  double overlap = 0;
  for (int i = 0; i < manifold.getNumContacts(); ++i)
    overlap = std::max(overlap, -manifold.getContactPoint(i).getDistance());
  return overlap;
}

bool pair_less(const Allowance& left, const Allowance& right) {
  return std::tie(left.a, left.b) < std::tie(right.a, right.b);
}

/// Whether this is the ground under a supported body that has just moved: one that stands still loads its supports.
bool is_kinematic_on_ground(const Object& a, const Object& b) {
  const bool has_ground = a.kind == Kind::ground || b.kind == Kind::ground;
  return has_ground && (a.body->isActive() || b.body->isActive());
}

}  // namespace

bool ContactWorld::Impl::all_at_rest() const {
  return std::none_of(objects.begin(), objects.end(),
                      [](const Object& object) { return object.body && (object.fresh || object.body->isActive()); });
}

void ContactWorld::Impl::detect() {
  for (Object& object : objects) {
    object.first_velocity = object.state.velocity;
    object.first_spin = object.state.angular_velocity;
  }
  delete_retired();
  past_node_contacts = std::move(node_contacts);
  std::ranges::sort(past_node_contacts, std::ranges::less(), &NodeContact::key);
  node_contacts.clear();
  if (all_at_rest()) {
    contacts.clear();
    memories.clear();
    return;
  }
  world.performDiscreteCollisionDetection();
  forget_parted();
  collect_manifolds();
  update_allowances();
  wake_disturbed();
  list_contacts();
  for (Object& object : objects) object.fresh = false;
}

/// What a copied world remembers of pairs that it has looked at by now without need of it, or that have parted.
void ContactWorld::Impl::forget_parted() {
  dispatcher.forget_if([&](const PairKey& pair) {
    const btCollisionObject *a = objects[pair.first].body.get(), *b = objects[pair.second].body.get();
    return dispatcher.needsCollision(a, b) || !pairs.findPair(const_cast<btBroadphaseProxy*>(a->getBroadphaseHandle()),
                                                              const_cast<btBroadphaseProxy*>(b->getBroadphaseHandle()));
  });
}

void ContactWorld::Impl::collect_manifolds() {
  using Order = decltype(order_of(nullptr));
  std::vector<std::pair<Order, btPersistentManifold*>> ordered;
  dispatcher.visit_touching(
      [&](btPersistentManifold* manifold) { ordered.emplace_back(order_of(manifold), manifold); });
  std::ranges::sort(ordered, {}, &std::pair<Order, btPersistentManifold*>::first);
  manifolds.clear();
  for (const auto& [order, manifold] : ordered) manifolds.push_back(manifold);
}

void ContactWorld::Impl::update_allowances() {
  std::vector<Allowance> overlaps;  // one per pair: manifolds of a pair are neighbours
  for (const btPersistentManifold* manifold : manifolds) {
    const ProxyId a = id_of(manifold->getBody0()), b = id_of(manifold->getBody1());
    if (overlaps.empty() || overlaps.back().a != a || overlaps.back().b != b) overlaps.push_back({a, b, 0});
    overlaps.back().overlap = std::max(overlaps.back().overlap, largest_overlap(*manifold));
  }
  std::erase_if(overlaps, [&](Allowance& pair) {
    const Object &a = objects[pair.a], &b = objects[pair.b];
    const bool fresh = (a.fresh || b.fresh) && a.kind != Kind::ground && b.kind != Kind::ground;
    if (!fresh) pair.overlap = std::min(pair.overlap, allowance(pair.a, pair.b));
    return pair.overlap == 0;
  });
  allowances = std::move(overlaps);
}

double ContactWorld::Impl::allowance(ProxyId a, ProxyId b) const {
  const Allowance wanted{a, b, 0};
  const auto found = std::lower_bound(allowances.begin(), allowances.end(), wanted, pair_less);
  return found != allowances.end() && found->a == a && found->b == b ? found->overlap : 0;
}

void ContactWorld::Impl::list_contacts() {
  contacts.clear();
  memories.clear();
  for (auto first = manifolds.begin(); first != manifolds.end();) {
    const auto same_pair = [&](const btPersistentManifold* manifold) {
      return manifold->getBody0() == (*first)->getBody0() && manifold->getBody1() == (*first)->getBody1();
    };
    const auto end = std::find_if_not(first, manifolds.end(), same_pair);
    const Object &a = objects[id_of((*first)->getBody0())], &b = objects[id_of((*first)->getBody1())];
    if (a.moves() || b.moves() || is_kinematic_on_ground(a, b)) list_pair({first, end});
    first = end;
  }
  sort_by_height();
}

/// Sweeps down through a pile carry its load at once.
void ContactWorld::Impl::sort_by_height() {
  std::vector<std::pair<double, int>> order;
  for (std::size_t i = 0; i < contacts.size(); ++i)
    order.emplace_back(gravity.dot(contacts[i].position), static_cast<int>(i));
  std::sort(order.begin(), order.end());
  std::vector<Contact> sorted_contacts;
  std::vector<Memory> sorted_memories;
  for (const auto& [depth, i] : order) {
    sorted_contacts.push_back(contacts[i]);
    sorted_memories.push_back(memories[i]);
  }
  contacts = std::move(sorted_contacts);
  memories = std::move(sorted_memories);
}

void ContactWorld::Impl::list_pair(std::span<btPersistentManifold* const> of_pair) {
  std::vector<Contact> found;
  std::vector<btManifoldPoint*> found_points;
  for (btPersistentManifold* manifold : of_pair)
    for (int i = 0; i < manifold->getNumContacts(); ++i) {
      btManifoldPoint& point = manifold->getContactPoint(i);
      found_points.push_back(&point);
      found.push_back({id_of(manifold->getBody0()), id_of(manifold->getBody1()),
                       from_bullet(0.5 * (point.m_positionWorldOnA + point.m_positionWorldOnB)),
                       from_bullet(point.m_normalWorldOnB), point.getDistance()});
    }
  std::vector<bool> listed(found.size(), false);
  for (int kept : representative_contacts(found)) {
    contacts.push_back(found[kept]);
    memories.push_back({found_points[kept]});
    listed[kept] = true;
  }
  for (std::size_t i = 0; i < found.size(); ++i)
    if (!listed[i]) remember_force({found_points[i]}, Vec3::Zero());
}

void ContactWorld::Impl::replace_contacts(const std::vector<bool>& taken_out, std::span<const Contact> put_in) {
  assert(taken_out.size() == contacts.size());
  std::size_t kept = 0;
  for (std::size_t i = 0; i < contacts.size(); ++i) {
    if (taken_out[i]) {
      remember_force(memories[i], Vec3::Zero());
      continue;
    }
    contacts[kept] = contacts[i];
    memories[kept++] = memories[i];
  }
  contacts.resize(kept);
  memories.resize(kept);
  for (const Contact& contact : put_in) {
    NodeContact added{contact.a, contact.b, contact.node_a, contact.node_b};
    const auto past = std::ranges::lower_bound(past_node_contacts, added.key(), std::ranges::less(), &NodeContact::key);
    if (past != past_node_contacts.end() && past->key() == added.key()) added.force = past->force;
    contacts.push_back(contact);
    memories.push_back({nullptr, static_cast<int>(node_contacts.size())});
    node_contacts.push_back(added);
  }
  sort_by_height();
}

Vec3 ContactWorld::Impl::remembered_force(const Memory& memory) const {
  if (!memory.point) return node_contacts[memory.node_contact].force;
  return {memory.point->m_appliedImpulse, memory.point->m_appliedImpulseLateral1,
          memory.point->m_appliedImpulseLateral2};
}

void ContactWorld::Impl::remember_force(const Memory& memory, const Vec3& force) {
  if (!memory.point) {
    node_contacts[memory.node_contact].force = force;
    return;
  }
  memory.point->m_appliedImpulse = force[0];
  memory.point->m_appliedImpulseLateral1 = force[1];
  memory.point->m_appliedImpulseLateral2 = force[2];
}

}  // namespace griffith
