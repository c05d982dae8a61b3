#include "sim/world/output/publish.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <tuple>
#include <utility>

#include "sim/world/energy/energy_phase.h"
#include "sim/world/state/world_state.h"

namespace griffith {
namespace {

BodyView view_of(const Body& body) {
  return {body.id,          body.parent,          body.scene_body,      static_cast<int>(body.tets.size()),
          body.motion.mass, body.motion.center,   body.motion.velocity, body.motion.angular_velocity,
          body.orientation, body.collision_parts, body.supported(),     body.rigid,
          body.asleep,      body.scaled,          body.broke_scaled};
}

/// True if a sleeper is at the place of its view of the last step.
bool still_shows(const BodyView& view, const Body& body) {
  return body.asleep && view.asleep && view.center_of_mass == body.motion.center &&
         view.orientation.coeffs() == body.orientation.coeffs() && !view.scaled && !body.scaled &&
         view.broke_scaled == body.broke_scaled;
}

void add_nodes(const WorldState& world, Totals& totals) {
  for (std::size_t i = 0; i < world.nodes.positions.size(); ++i) {
    const double mass = world.nodes.masses[i];
    const Vec3 momentum = mass * world.nodes.velocities[i];
    totals.mass += mass;
    if (world.nodes.velocities[i].isZero(0)) continue;
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

void publish(WorldState& world) {
  world.output.totals = {};
  world.output.bodies.resize(world.bodies.size());
  world.output.projectiles.clear();
  for (const Body& body : world.bodies) {
    BodyView& view = world.output.bodies[body.id];
    if (!still_shows(view, body)) view = view_of(body);
  }
  add_nodes(world, world.output.totals);
  for (const Body& body : world.bodies)
    if (!body.rigid) world.output.totals.kinetic_energy += kinetic_energy_of_edges(world, body.edges);
  for (std::size_t i = 0; i < world.elements.rest_elements.size(); ++i)
    world.output.totals.elastic_energy +=
        world.elements.rest_elements[i].volume * world.elements.states[i].energy_density;
  for (const Projectile& projectile : world.projectiles) {
    const RigidState state = world.contact_world.state(projectile.object);
    world.output.projectiles.push_back(view_of(projectile, state));
    add_projectile(projectile, state, world.output.totals);
  }
  world.output.contacts = merged_contacts(world, world.output.contacts);
  close_account(world, world.output.totals.elastic_energy);
  world.output.load_forces.clear();
  if (world.loads.empty()) return;
  ExternalForces forces = no_forces(world);
  add_load_forces(world, world.time, forces);
  world.output.load_forces = std::move(forces.nodes);
}

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
    views.push_back({world.body_of(contact.a), world.body_of(contact.b), contact.position, contact.normal,
                     contact.impulse, std::max(0.0, -contact.distance), contact.approach});
  }
}

void merge(ContactView& contact, const ContactView& other) {
  const double weight = contact.impulse.norm(), other_weight = other.impulse.norm(), sum = weight + other_weight;
  contact.position = (weight * contact.position + other_weight * other.position) / sum;
  contact.normal = (weight * contact.normal + other_weight * other.normal).normalized();
  contact.impulse += other.impulse;
  contact.depth = std::max(contact.depth, other.depth);
  contact.approach = std::max(contact.approach, other.approach);
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
