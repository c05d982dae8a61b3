#include "sim/world/publish.h"

#include "sim/world/contact_views.h"
#include "sim/world/energy/energy_phase.h"
#include "sim/world/world_state.h"

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
    if (!body.rigid) world.output.totals.kinetic_energy += kinetic_energy_of_edges(world, body);
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
  world.output.load_forces.assign(world.loads.empty() ? 0 : world.nodes.positions.size(), Vec3::Zero());
  if (!world.loads.empty()) add_load_forces(world, world.time, world.output.load_forces);
}

}  // namespace griffith
