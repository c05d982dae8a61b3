#include "sim/world/publish.h"

#include <algorithm>
#include <cmath>
#include <tuple>
#include <utility>

#include "sim/world/energy/energy_phase.h"
#include "sim/world/world_state.h"

namespace griffith {
namespace {

/// The elements near which a contact acts, as cells of half an element's size: contacts in one cell show as one.
std::array<std::int64_t, 3> contact_cell(const WorldState& world, const ContactView& contact) {
  const BodyId body = contact.a.valid() ? contact.a : contact.b;
  if (!body.valid()) return {};
  const Vec3 place = contact.position / (0.5 * world.bodies[body].element_size);
  constexpr double kFarthest = 1e15;
  std::array<std::int64_t, 3> cell;
  for (int i = 0; i < 3; ++i) cell[i] = std::llround(std::clamp(place[i], -kFarthest, kFarthest));
  return cell;
}

/// `contact` becomes the mean of both, weighted by their impulses, which are added up.
void merge(ContactView& contact, const ContactView& other) {
  const double weight = contact.impulse.norm(), other_weight = other.impulse.norm(), sum = weight + other_weight;
  contact.position = (weight * contact.position + other_weight * other.position) / sum;
  contact.normal = (weight * contact.normal + other_weight * other.normal).normalized();
  contact.impulse += other.impulse;
}

/// The contacts of all substeps, those at one place merged.
void merge_contacts(WorldState& world) {
  using Key = std::tuple<BodyId, BodyId, std::array<std::int64_t, 3>>;
  std::vector<std::pair<Key, ContactView>> contacts;
  for (const ContactView& contact : world.contact_views)
    contacts.emplace_back(Key(contact.a, contact.b, contact_cell(world, contact)), contact);
  std::ranges::stable_sort(contacts, {}, &std::pair<Key, ContactView>::first);
  world.contact_views.clear();
  for (std::size_t i = 0; i < contacts.size(); ++i) {
    if (i > 0 && contacts[i].first == contacts[i - 1].first) {
      merge(world.contact_views.back(), contacts[i].second);
    } else {
      world.contact_views.push_back(contacts[i].second);
    }
  }
}

BodyView view_of(const Body& body) {
  return {body.id,          body.parent,          body.scene_body,      static_cast<int>(body.tets.size()),
          body.motion.mass, body.motion.center,   body.motion.velocity, body.motion.angular_velocity,
          body.orientation, body.collision_parts, body.supported(),     body.rigid,
          body.asleep,      body.scaled};
}

void add_nodes(const WorldState& world, Totals& totals) {
  for (std::size_t i = 0; i < world.nodes.positions.size(); ++i) {
    const double mass = world.nodes.masses[i];
    const Vec3 momentum = mass * world.nodes.velocities[i];
    totals.mass += mass;
    totals.momentum += momentum;
    totals.angular_momentum += world.nodes.positions[i].cross(momentum);
    totals.kinetic_energy += 0.5 * momentum.dot(world.nodes.velocities[i]);
  }
}

void add_projectile(const Projectile& projectile, const RigidState& state, Totals& totals) {
  const Quat& rotation = state.pose.rotation;
  const Vec3 spin = rotation * (projectile.inertia * (rotation.conjugate() * state.angular_velocity));
  totals.mass += projectile.mass;
  totals.momentum += projectile.mass * state.velocity;
  totals.angular_momentum += projectile.mass * state.pose.translation.cross(state.velocity) + spin;
  totals.kinetic_energy +=
      0.5 * projectile.mass * state.velocity.squaredNorm() + 0.5 * spin.dot(state.angular_velocity);
}

ProjectileView view_of(const Projectile& projectile, const RigidState& state) {
  ProjectileView view{
      state.pose.translation, state.velocity, state.pose.rotation, projectile.radius, projectile.mass, {}, {}};
  if (projectile.hull) {
    view.corners = projectile.hull->corners;
    view.faces = projectile.hull->faces;
  }
  return view;
}

}  // namespace

void record_contacts(WorldState& world) {
  for (const Contact& contact : std::as_const(world.contact_world).contacts()) {
    if (contact.impulse.isZero(0)) continue;
    world.contact_views.push_back(
        {world.body_of(contact.a), world.body_of(contact.b), contact.position, contact.normal, contact.impulse});
  }
}

void publish(WorldState& world) {
  world.totals = {};
  world.body_views.clear();
  world.projectile_views.clear();
  for (const Body& body : world.bodies) world.body_views.push_back(view_of(body));
  add_nodes(world, world.totals);
  for (std::size_t i = 0; i < world.elements.rest_elements.size(); ++i)
    world.totals.elastic_energy += world.elements.rest_elements[i].volume * world.elements.states[i].energy_density;
  for (const Projectile& projectile : world.projectiles) {
    const RigidState state = world.contact_world.state(projectile.object);
    world.projectile_views.push_back(view_of(projectile, state));
    add_projectile(projectile, state, world.totals);
  }
  merge_contacts(world);
  close_account(world, world.totals.elastic_energy);
  world.load_forces.assign(world.loads.empty() ? 0 : world.nodes.positions.size(), Vec3::Zero());
  if (!world.loads.empty()) add_load_forces(world, world.time, world.load_forces);
}

}  // namespace griffith
