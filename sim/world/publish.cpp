#include "sim/world/phases.h"

namespace griffith {
namespace {

BodyView view_of(const Body& body) {
  return {body.id,
          body.parent,
          body.scene_body,
          static_cast<int>(body.tets.size()),
          body.motion.mass,
          body.motion.center,
          body.motion.velocity,
          body.motion.angular_velocity,
          body.supported(),
          body.asleep};
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

void add_projectile(const ProjectileView& projectile, const RigidState& state, Totals& totals) {
  const double inertia = 0.4 * projectile.mass * projectile.radius * projectile.radius;
  totals.mass += projectile.mass;
  totals.momentum += projectile.mass * state.velocity;
  totals.angular_momentum +=
      projectile.mass * projectile.position.cross(state.velocity) + inertia * state.angular_velocity;
  totals.kinetic_energy +=
      0.5 * projectile.mass * state.velocity.squaredNorm() + 0.5 * inertia * state.angular_velocity.squaredNorm();
}

}  // namespace

void publish(WorldState& world) {
  world.totals = {};
  world.body_views.clear();
  world.projectile_views.clear();
  for (const Body& body : world.bodies) world.body_views.push_back(view_of(body));
  add_nodes(world, world.totals);
  for (std::size_t i = 0; i < world.elements.rests.size(); ++i)
    world.totals.elastic_energy += world.elements.rests[i].volume * world.elements.states[i].energy_density;
  for (const Projectile& projectile : world.projectiles) {
    const RigidState state = world.contact_world.state(projectile.object);
    world.projectile_views.push_back(
        {state.pose.translation, state.velocity, state.pose.rotation, projectile.radius, projectile.mass});
    add_projectile(world.projectile_views.back(), state, world.totals);
  }
}

}  // namespace griffith
