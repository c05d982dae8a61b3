#include "sim/contact/bullet/contact_world.h"

#include <Eigen/LU>
#include <cassert>

#include "sim/core/parallel.h"

namespace griffith {

using namespace contact;

namespace {

/// Fraction of its radius by which a held object may move without disturbing sleepers.
constexpr double kNegligibleMove = 1e-5;

[[maybe_unused]] bool is_valid(const RigidState& state) {
  return state.pose.translation.allFinite() && state.pose.rotation.coeffs().allFinite() && state.velocity.allFinite() &&
         state.angular_velocity.allFinite();
}

}  // namespace

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
  object.exists = object.fresh = true;
  object.active = is_free;
  object.resting_place = object.state.pose;
  place(object);
}

void ContactWorld::Impl::retire(ProxyId id) {
  Object& object = objects[id];
  const int index = static_cast<int>(id.index());
  erase_pairs([&](const Pair& pair) { return pair.a == index || pair.b == index; });
  for (const int leaf : object.leaves) tree.remove(leaf);
  object.leaves.clear();
  object.exists = object.active = false;
  if (index == ground) ground = -1;
  contacts.clear();
  memories.clear();
}

void ContactWorld::Impl::place(Object& object) {
  assert(is_valid(object.state));
  object.place = {object.state.pose.rotation.toRotationMatrix(), object.state.pose.translation};
}

ContactWorld::ContactWorld(const Vec3& gravity) : impl_(std::make_unique<Impl>(gravity)) {}
ContactWorld::~ContactWorld() = default;
ContactWorld::ContactWorld(const ContactWorld& other) : impl_(std::make_unique<Impl>(*other.impl_)) {}
ContactWorld& ContactWorld::operator=(const ContactWorld& other) { return *this = ContactWorld(other); }
ContactWorld::ContactWorld(ContactWorld&&) noexcept = default;
ContactWorld& ContactWorld::operator=(ContactWorld&&) noexcept = default;

ProxyId ContactWorld::add_ground(double height, const SurfaceProperties& surface) {
  impl_->ground_height = height;
  const ProxyId id =
      impl_->add({.kind = Kind::ground, .mobility = Mobility::kinematic, .shape = {}, .surface = surface}, {});
  impl_->ground = static_cast<int>(id.index());
  return id;
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
  assert(object.kind == Kind::proxy && object.exists);
  impl_->wake_up(proxy);
  impl_->wake_neighbors(proxy);
  impl_->retire(proxy);
  object.mobility = mobility;
  object.state = state;
  object.shape = hull_shape(parts);
  impl_->attach(proxy, mass);
  object.parted = true;
}

void ContactWorld::deform(ProxyId proxy, std::span<const ConvexPart> parts, const RigidMass& mass,
                          const RigidState& state) {
  Object& object = impl_->objects[proxy];
  const bool parted = object.fresh && object.parted;
  reshape(proxy, parts, mass, object.mobility, state);
  object.parted = parted;
}

void ContactWorld::remove(ProxyId object) {
  assert(impl_->objects[object].exists);
  impl_->wake_up(object);
  impl_->wake_neighbors(object);
  impl_->retire(object);
}

void ContactWorld::set_state(ProxyId object, const RigidState& state) {
  Object& changed = impl_->objects[object];
  assert(changed.kind != Kind::ground && changed.exists);
  if (changed.mobility == Mobility::kinematic) {
    const bool moved =
        has_left(changed.resting_place, state.pose, kNegligibleMove * changed.shape.radius, changed.shape.radius);
    changed.active = moved;
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
  if (impl_->ground < 0) return {};
  return ProxyId(impl_->ground);
}
bool ContactWorld::is_ground(ProxyId object) const { return impl_->objects[object].kind == Kind::ground; }
bool ContactWorld::moves(ProxyId object) const { return impl_->objects[object].moves(); }
double ContactWorld::allowed_overlap(ProxyId a, ProxyId b) const {
  return std::max(impl_->allowance(a, b), impl_->allowance(b, a));
}
void ContactWorld::detect(double dt) { impl_->detect(dt); }
std::span<Contact> ContactWorld::contacts() { return impl_->contacts; }
std::span<const Contact> ContactWorld::contacts() const { return impl_->contacts; }
std::vector<int> ContactWorld::drop_near_misses(double dt, std::span<const double> approach) {
  return impl_->drop_near_misses(dt, approach);
}
void ContactWorld::replace_contacts(const std::vector<bool>& taken_out, std::span<const Contact> put_in) {
  impl_->replace_contacts(taken_out, put_in);
}
void ContactWorld::drop_contacts_of(const std::vector<bool>& objects) { impl_->drop_contacts_of(objects); }
int ContactWorld::solve(double dt, std::span<const ElasticObject> elastic, std::span<const HingedObject> hinged) {
  return impl_->solve(dt, elastic, hinged);
}
void ContactWorld::leave_unsettled_groups(double dt) { impl_->leave_unsettled_groups(dt); }
std::vector<std::vector<int>> ContactWorld::elastic_groups() const { return impl_->elastic_groups(); }
ContactWorld::Law ContactWorld::law(int contact) const { return impl_->laws[impl_->law_of_contact[contact]]; }
std::optional<RigidMass> ContactWorld::rigid_mass(ProxyId object) const {
  const Object& found = impl_->objects[object];
  if (found.hinge >= 0) return impl_->hinged_mass(found);
  if (!found.moves() || found.elastic) return {};
  return RigidMass{1 / found.inverse_mass, world_inertia(found)};
}
void ContactWorld::advance(double dt) { impl_->advance(dt); }
ContactWorld::Correction ContactWorld::position_correction(ProxyId proxy) const {
  return impl_->objects[proxy].correction;
}
Vec3 ContactWorld::pushed_out(ProxyId projectile) const { return impl_->objects[projectile].pushed_out; }
Vec3 ContactWorld::swept_center(ProxyId proxy, double dt, double slow,
                                const std::function<bool(ProxyId)>& stops) const {
  std::vector<Impl::Pushed> pushed;  // bodies push nothing
  return impl_->swept_end(impl_->objects[proxy], dt, {slow, stops}, pushed);
}
Vec3 ContactWorld::velocity_after(const Vec3& velocity, const Vec3& displacement, double dt) const {
  return impl_->velocity_after(velocity, displacement, dt);
}
std::vector<ContactWorld::Encounter> ContactWorld::expected_impacts(double dt, double minimum_speed, double tolerance,
                                                                    const PairFilter& matters) const {
  return impl_->expected_impacts(dt, {minimum_speed, tolerance}, matters);
}
std::vector<ContactWorld::Meeting> ContactWorld::unlisted_meetings(double dt, double minimum_speed, double tolerance,
                                                                   const std::vector<bool>& left_out) const {
  return impl_->unlisted_meetings(dt, {minimum_speed, tolerance}, left_out);
}
std::size_t ContactWorld::memory() const {
  return impl_->objects.size() * sizeof(Object) + impl_->tree.memory() + impl_->pairs.size() * sizeof(Pair) +
         impl_->manifolds.size() * sizeof(Manifold) +
         impl_->contacts.size() * (sizeof(Contact) + sizeof(Memory) + sizeof(int)) + impl_->laws.size() * sizeof(Law);
}
double ContactWorld::max_penetration() const {
  double deepest = 0;
  for (const Contact& contact : impl_->contacts)
    deepest = std::max(deepest, -distance_beyond(contact.distance, impl_->allowance(contact.a, contact.b)));
  return deepest;
}

}  // namespace griffith
