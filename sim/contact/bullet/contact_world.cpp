#include "sim/contact/bullet/contact_world.h"

#include <Eigen/LU>
#include <cassert>

#include "sim/core/parallel.h"

namespace griffith {

using namespace contact;

namespace {

constexpr int kMovingGroup = 1, kKinematicGroup = 2, kGroundGroup = 4;
/// A held object that is displaced by a smaller share of its radius since it last moved does not disturb sleepers.
constexpr double kNegligibleMove = 1e-5;

[[maybe_unused]] bool is_valid(const RigidState& state) {
  return state.pose.translation.allFinite() && state.pose.rotation.coeffs().allFinite() && state.velocity.allFinite() &&
         state.angular_velocity.allFinite();
}

/// What may touch what: supported bodies bend and swing down to the ground, but keep out of each other's way.
int partners_of(int group) {
  switch (group) {
    case kMovingGroup:
      return kMovingGroup | kKinematicGroup | kGroundGroup;
    case kKinematicGroup:
      return kMovingGroup | kGroundGroup;
    default:
      return kMovingGroup | kKinematicGroup;
  }
}

bool is_retired(const btBroadphaseProxy* proxy) {
  return static_cast<const btCollisionObject*>(proxy->m_clientObject)->getUserIndex() == kRetired;
}

/// Bullet takes the memory for its algorithms from a pool of pieces of one size.
btDefaultCollisionConstructionInfo with_room_for(int pairs) {
  btDefaultCollisionConstructionInfo info;
  info.m_defaultMaxPersistentManifoldPoolSize = info.m_defaultMaxCollisionAlgorithmPoolSize = pairs;
  info.m_customCollisionAlgorithmMaxElementSize = static_cast<int>(
      std::max({sizeof(HullHullAlgorithm), sizeof(SphereHullAlgorithm), sizeof(SphereGroundAlgorithm)}));
  return info;
}

struct DeletePairs final : btOverlapCallback {
  bool all = false;
  bool processOverlap(btBroadphasePair& pair) override {
    return all || is_retired(pair.m_pProxy0) || is_retired(pair.m_pProxy1);
  }
};

}  // namespace

namespace contact {

OwnedObject::OwnedObject(const OwnedObject& other) {
  if (!other) return;
  object_ = std::make_unique<btCollisionObject>(*other.object_);
  object_->setBroadphaseHandle(nullptr);
  object_->setWorldArrayIndex(-1);
}

void CollisionWorld::updateAabbs() {
  for (int i = 0; i < m_collisionObjects.size(); ++i) {
    const btCollisionObject* object = m_collisionObjects[i];
    if (!object->isActive() && !object->isStaticObject()) continue;
    btBroadphaseProxy* proxy = m_collisionObjects[i]->getBroadphaseHandle();
    btVector3 minimum, maximum;
    object->getCollisionShape()->getAabb(object->getWorldTransform(), minimum, maximum);
    if (!object->getCollisionShape()->isInfinite()) {
      const btScalar reach = contact_reach(*object);
      minimum -= btVector3(reach, reach, reach);
      maximum += btVector3(reach, reach, reach);
    }
    if (minimum != proxy->m_aabbMin || maximum != proxy->m_aabbMax)
      tree_->setAabbForceUpdate(proxy, minimum, maximum, getDispatcher());
  }
}

}  // namespace contact

ContactWorld::Impl::Impl(const Vec3& world_gravity, int pairs_expected)
    : configuration(with_room_for(pairs_expected)),
      dispatcher(&configuration),
      broadphase(&pairs),
      world(&dispatcher, &broadphase, &configuration) {
  assert(world_gravity.allFinite());
  gravity = world_gravity;
  broadphase.m_cupdates = 100;  // drop pairs as soon as they part
  ground_hull.m_swapped = ground_sphere.m_swapped = true;
  dispatcher.registerCollisionCreateFunc(CONVEX_HULL_SHAPE_PROXYTYPE, STATIC_PLANE_PROXYTYPE, &hull_ground);
  dispatcher.registerCollisionCreateFunc(STATIC_PLANE_PROXYTYPE, CONVEX_HULL_SHAPE_PROXYTYPE, &ground_hull);
  dispatcher.registerCollisionCreateFunc(CONVEX_HULL_SHAPE_PROXYTYPE, CONVEX_HULL_SHAPE_PROXYTYPE, &hull_hull);
  dispatcher.registerCollisionCreateFunc(SPHERE_SHAPE_PROXYTYPE, SPHERE_SHAPE_PROXYTYPE, &sphere_sphere);
  dispatcher.registerCollisionCreateFunc(SPHERE_SHAPE_PROXYTYPE, CONVEX_HULL_SHAPE_PROXYTYPE, &sphere_hull);
  dispatcher.registerCollisionCreateFunc(CONVEX_HULL_SHAPE_PROXYTYPE, SPHERE_SHAPE_PROXYTYPE, &sphere_hull);
  dispatcher.registerCollisionCreateFunc(SPHERE_SHAPE_PROXYTYPE, STATIC_PLANE_PROXYTYPE, &sphere_ground);
  dispatcher.registerCollisionCreateFunc(STATIC_PLANE_PROXYTYPE, SPHERE_SHAPE_PROXYTYPE, &ground_sphere);
}

/// Most copies are kept and not used: they have little room for more.
ContactWorld::Impl::Impl(const Impl& other)
    : Impl(other.gravity, std::clamp(static_cast<int>(other.dispatcher.pair_count()), 64, 4096)) {
  ContactState::operator=(other);
  enter_all(other);
  dispatcher.restore(other.dispatcher.memories(), [&](int index) { return objects[index].body.get(); });
}

/// In the order in which they entered the other world, by which Bullet orders the sides of pairs, and with the boxes
/// that they have there.
void ContactWorld::Impl::enter_all(const Impl& other) {
  std::vector<int> order;
  for (std::size_t i = 0; i < objects.size(); ++i)
    if (objects[i].body) order.push_back(static_cast<int>(i));
  const auto their_proxy = [&](int i) { return other.objects[i].body->getBroadphaseHandle(); };
  std::ranges::sort(order, {}, [&](int i) { return their_proxy(i)->m_uniqueId; });
  for (int i : order) {
    enter(objects[i]);
    broadphase.setAabbForceUpdate(objects[i].body->getBroadphaseHandle(), their_proxy(i)->m_aabbMin,
                                  their_proxy(i)->m_aabbMax, &dispatcher);
  }
}

ContactWorld::Impl::~Impl() {
  DeletePairs delete_pairs;
  delete_pairs.all = true;
  pairs.processAllOverlappingPairs(&delete_pairs, &dispatcher);
}

ProxyId ContactWorld::Impl::add(Object object, const RigidMass& mass) {
  const ProxyId id(objects.size());
  objects.push_back(std::move(object));
  attach(id, mass);
  return id;
}

void ContactWorld::Impl::attach(ProxyId id, const RigidMass& mass) {
  Object& object = objects[id];
  const bool is_free = object.mobility == Mobility::free;
  assert(!is_free || (mass.mass > 0 && mass.inertia.allFinite()));
  object.inverse_mass = is_free ? 1 / mass.mass : 0;
  object.inverse_inertia = is_free ? Mat3(mass.inertia.inverse()) : Mat3(Mat3::Zero());
  object.body = OwnedObject(std::make_unique<btCollisionObject>());
  object.body->setCollisionShape(object.shape.root());
  object.body->setUserIndex(id.index());
  object.body->setCollisionFlags(is_free ? 0 : static_cast<int>(btCollisionObject::CF_STATIC_OBJECT));
  // A pair is looked at when one of them is active: what cannot move is not.
  object.body->forceActivationState(is_free ? ACTIVE_TAG : ISLAND_SLEEPING);
  place(object);
  enter(object);
  object.resting_place = object.state.pose;
  object.fresh = true;
}

void ContactWorld::Impl::enter(Object& object) {
  const bool is_free = object.mobility == Mobility::free;
  const int group = is_free ? kMovingGroup : object.kind == Kind::ground ? kGroundGroup : kKinematicGroup;
  world.addCollisionObject(object.body.get(), group, partners_of(group));
}

void ContactWorld::Impl::retire(Object& object) {
  const int index = object.body->getUserIndex();
  dispatcher.forget_if([&](const PairKey& pair) { return pair.first == index || pair.second == index; });
  object.body->setUserIndex(kRetired);
  retired.push_back({std::move(object.shape), std::move(object.body)});
  manifolds.clear();
  contacts.clear();
}

void ContactWorld::Impl::delete_retired() {
  if (retired.empty()) return;
  DeletePairs delete_pairs;
  pairs.processAllOverlappingPairs(&delete_pairs, &dispatcher);
  for (Retired& object : retired) world.removeCollisionObject(object.body.get());
  retired.clear();
}

void ContactWorld::Impl::place(Object& object) {
  assert(is_valid(object.state));
  object.body->setWorldTransform(to_bullet(object.state.pose));
}

ContactWorld::ContactWorld(const Vec3& gravity) : impl_(std::make_unique<Impl>(gravity)) {}
ContactWorld::~ContactWorld() = default;
ContactWorld::ContactWorld(const ContactWorld& other) : impl_(std::make_unique<Impl>(*other.impl_)) {}
ContactWorld& ContactWorld::operator=(const ContactWorld& other) { return *this = ContactWorld(other); }
ContactWorld::ContactWorld(ContactWorld&&) noexcept = default;
ContactWorld& ContactWorld::operator=(ContactWorld&&) noexcept = default;

ProxyId ContactWorld::add_ground(double height, const SurfaceProperties& surface) {
  impl_->ground_height = height;
  return impl_->add(
      {.kind = Kind::ground, .mobility = Mobility::kinematic, .shape = ground_shape(height), .surface = surface}, {});
}

ProxyId ContactWorld::add_sphere(double radius, double mass, const RigidState& state,
                                 const SurfaceProperties& surface) {
  const RigidMass rigid_mass{mass, 0.4 * mass * radius * radius * Mat3::Identity()};
  return impl_->add({.kind = Kind::projectile,
                     .mobility = Mobility::free,
                     .shape = sphere_shape(radius),
                     .state = state,
                     .surface = surface},
                    rigid_mass);
}

ProxyId ContactWorld::add_convex(const ConvexPart& corners, const RigidMass& mass, const RigidState& state,
                                 const SurfaceProperties& surface) {
  return impl_->add({.kind = Kind::projectile,
                     .mobility = Mobility::free,
                     .shape = hull_shape({&corners, 1}),
                     .state = state,
                     .surface = surface},
                    mass);
}

ProxyId ContactWorld::add_proxy(std::span<const ConvexPart> parts, const RigidMass& mass, Mobility mobility,
                                const RigidState& state, const SurfaceProperties& surface) {
  return add_proxies({{{parts, mass, mobility, state, surface}}}).front();
}

std::vector<ProxyId> ContactWorld::add_proxies(std::span<const Proxy> proxies) {
  std::vector<Shape> shapes(proxies.size());
  parallel_for(static_cast<int>(proxies.size()), 16, [&](int begin, int end) {
    for (int i = begin; i < end; ++i) shapes[i] = hull_shape(proxies[i].parts);
  });
  std::vector<ProxyId> ids;
  for (std::size_t i = 0; i < proxies.size(); ++i) {
    const Proxy& added = proxies[i];
    ids.push_back(impl_->add({.kind = Kind::proxy,
                              .mobility = added.mobility,
                              .shape = std::move(shapes[i]),
                              .state = added.state,
                              .surface = added.surface},
                             added.mass));
  }
  return ids;
}

void ContactWorld::reshape(ProxyId proxy, std::span<const ConvexPart> parts, const RigidMass& mass, Mobility mobility,
                           const RigidState& state) {
  Object& object = impl_->objects[proxy];
  assert(object.kind == Kind::proxy && object.body);
  impl_->wake_up(proxy);
  impl_->wake_neighbours(proxy);
  impl_->retire(object);
  object.mobility = mobility;
  object.state = state;
  object.shape = hull_shape(parts);
  impl_->attach(proxy, mass);
}

void ContactWorld::remove(ProxyId object) {
  assert(impl_->objects[object].body);
  impl_->wake_up(object);
  impl_->wake_neighbours(object);
  impl_->retire(impl_->objects[object]);
}

void ContactWorld::set_state(ProxyId object, const RigidState& state) {
  Object& changed = impl_->objects[object];
  assert(changed.kind != Kind::ground && changed.body);
  if (changed.mobility == Mobility::kinematic) {
    const bool moved =
        has_left(changed.resting_place, state.pose, kNegligibleMove * changed.shape.radius, changed.shape.radius);
    changed.body->forceActivationState(moved ? ACTIVE_TAG : ISLAND_SLEEPING);
    if (moved) changed.resting_place = state.pose;
  }
  changed.state = state;
  impl_->place(changed);
}

void ContactWorld::set_velocity(ProxyId object, const Vec3& velocity, const Vec3& angular_velocity) {
  impl_->objects[object].state.velocity = velocity;
  impl_->objects[object].state.angular_velocity = angular_velocity;
}

void ContactWorld::set_impact_speed(ProxyId object, double speed) { impl_->objects[object].impact_speed = speed; }
void ContactWorld::set_surface(ProxyId object, const SurfaceProperties& surface) {
  impl_->objects[object].surface = surface;
}

RigidState ContactWorld::state(ProxyId object) const { return impl_->objects[object].state; }
std::optional<ProxyId> ContactWorld::ground() const {
  const auto found = std::ranges::find(impl_->objects, contact::Kind::ground, &contact::Object::kind);
  if (found == impl_->objects.end()) return {};
  return ProxyId(static_cast<int>(found - impl_->objects.begin()));
}
bool ContactWorld::is_ground(ProxyId object) const { return impl_->objects[object].kind == Kind::ground; }
bool ContactWorld::moves(ProxyId object) const { return impl_->objects[object].moves(); }
double ContactWorld::allowed_overlap(ProxyId a, ProxyId b) const {
  return std::max(impl_->allowance(a, b), impl_->allowance(b, a));
}
void ContactWorld::detect() { impl_->detect(); }
std::span<Contact> ContactWorld::contacts() { return impl_->contacts; }
std::span<const Contact> ContactWorld::contacts() const { return impl_->contacts; }
std::vector<int> ContactWorld::drop_near_misses(double dt, std::span<const double> approach) {
  return impl_->drop_near_misses(dt, approach);
}
void ContactWorld::replace_contacts(const std::vector<bool>& taken_out, std::span<const Contact> put_in) {
  impl_->replace_contacts(taken_out, put_in);
}
void ContactWorld::drop_contacts_of(const std::vector<bool>& objects) { impl_->drop_contacts_of(objects); }
int ContactWorld::solve(double dt, std::span<const ElasticObject> elastic) { return impl_->solve(dt, elastic); }
std::vector<std::vector<int>> ContactWorld::elastic_groups() const { return impl_->elastic_groups(); }
ContactWorld::Law ContactWorld::law(int contact) const {
  const contact::ContactConstraint& row = impl_->solved[contact];
  return {row.axes,  row.target_velocity, row.friction, impl_->free_velocities[contact],
          row.a.arm, row.b.arm,           row.impulse};
}
std::optional<RigidMass> ContactWorld::rigid_mass(ProxyId object) const {
  const contact::Object& found = impl_->objects[object];
  if (!found.moves() || found.elastic) return {};
  const Mat3 rotation = found.state.pose.rotation.toRotationMatrix();
  return RigidMass{1 / found.inverse_mass, rotation * found.inverse_inertia.inverse() * rotation.transpose()};
}
void ContactWorld::advance(double dt) { impl_->advance(dt); }
ContactWorld::Correction ContactWorld::position_correction(ProxyId proxy) const {
  return impl_->objects[proxy].correction;
}
Vec3 ContactWorld::pushed_out(ProxyId projectile) const { return impl_->objects[projectile].pushed_out; }
Vec3 ContactWorld::swept_center(ProxyId proxy, double dt, double slow,
                                const std::function<bool(ProxyId)>& stops) const {
  return impl_->swept_end(impl_->objects[proxy], dt, {slow, stops});
}
Vec3 ContactWorld::velocity_after(const Vec3& velocity, const Vec3& displacement, double dt) const {
  return impl_->velocity_after(velocity, displacement, dt);
}
std::vector<ContactWorld::Encounter> ContactWorld::expected_impacts(double dt, double minimum_speed, double tolerance,
                                                                    const PairFilter& matters) const {
  return impl_->expected_impacts(dt, minimum_speed, tolerance, matters);
}
std::size_t ContactWorld::memory() const {
  constexpr std::size_t kOfBullet = 1200;  // an object of its own, its proxy and what finds them
  const std::size_t pairs = impl_->dispatcher.pair_count();
  const std::size_t in_pools =
      std::max<std::size_t>(pairs, 64) * (sizeof(btPersistentManifold) + sizeof(HullHullAlgorithm));
  return impl_->objects.size() * (sizeof(Object) + kOfBullet) + in_pools +
         pairs * (sizeof(PairMemory) + sizeof(PairKey) + 40) +
         impl_->contacts.size() * (sizeof(Contact) + sizeof(ContactConstraint));
}
double ContactWorld::max_penetration() const {
  double deepest = 0;
  for (const Contact& contact : impl_->contacts)
    deepest = std::max(deepest, -distance_beyond(contact.distance, impl_->allowance(contact.a, contact.b)));
  return deepest;
}

}  // namespace griffith
