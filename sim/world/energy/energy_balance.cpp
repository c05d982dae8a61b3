#include <cmath>

#include "sim/fracture/resistance.h"
#include "sim/world/energy/energy_phase.h"
#include "sim/world/motion/motion_phase.h"
#include "sim/world/state/world_state.h"

namespace griffith {
namespace {

double elastic_energy(const WorldState& world) {
  double sum = 0;
  for (std::size_t i = 0; i < world.elements.rest_elements.size(); ++i)
    sum += world.elements.rest_elements[i].volume * world.elements.states[i].energy_density;
  return sum;
}

double kinetic_energy(const WorldState& world) {
  double sum = kinetic_energy_of_projectiles(world);
  for (const Body& body : world.bodies)
    sum += body.rigid ? kinetic_energy(body.motion) : kinetic_energy_of(world, body);
  return sum;
}

double potential_energy(const WorldState& world) {
  Vec3 moment = Vec3::Zero();
  for (std::size_t i = 0; i < world.nodes.positions.size(); ++i)
    moment += world.nodes.masses[i] * world.nodes.positions[i];
  for (const Projectile& projectile : world.projectiles)
    moment += projectile.mass * world.contact_world.state(projectile.object).pose.translation;
  return -world.model->scene.gravity.dot(moment);
}

}  // namespace

double elastic_energy(const WorldState& world, const Body& body) {
  double energy = 0;
  for (TetId tet : body.tets)
    energy += world.elements.rest_elements[tet].volume * world.elements.states[tet].energy_density;
  return energy;
}

double kinetic_energy_of_edges(const WorldState& world, std::span<const EdgeId> edges) {
  double sum = 0;
  for (EdgeId edge : edges) sum += 0.5 * world.edges.masses[edge] * world.edges.velocities[edge].squaredNorm();
  return sum;
}

double energy_of(const WorldState& world, const Body& body) {
  return body.rigid ? kinetic_energy(body.motion) + elastic_energy(world, body) : mechanical_energy(world, body);
}

EnergyNow energy_now(const WorldState& world) {
  return {kinetic_energy(world) + elastic_energy(world), potential_energy(world), world.energy.lost()};
}

void open_account(WorldState& world) {
  world.energy = {};
  world.potential_at_start = potential_energy(world);
  close_account(world, elastic_energy(world));
  world.energy.start = world.energy.stored();
  world.energy_before = world.energy;
}

void close_account(WorldState& world, double elastic) {
  world.energy.kinetic = kinetic_energy(world);
  world.energy.elastic = elastic;
  world.energy.gravity = world.potential_at_start - potential_energy(world);
}

void account_edit(WorldState& world, const EnergyNow& before) {
  if (world.step == 0) return open_account(world);
  const EnergyNow now = energy_now(world);
  world.energy.edits += now.stored + now.lost - before.stored - before.lost;
  world.potential_at_start += now.potential - before.potential;
}

void account_launch(WorldState& world, const Projectile& projectile, const RigidState& state) {
  world.energy.projectiles += kinetic_energy(projectile, state);
  world.potential_at_start -= projectile.mass * world.model->scene.gravity.dot(state.pose.translation);
}

void account_crack(WorldState& world, TetId tet, int face, double part) {
  const auto corner = [&](int i) { return world.mesh->rest_positions[world.mesh->tets[tet][kTetFaces[face][i]]]; };
  const double area =
      0.25 * part * (corner(1) - corner(0)).cross(corner(2) - corner(0)).norm();  // the other side counts half
  world.energy.crack_area += area;
  world.energy.fracture_energy += area * fracture_energy(world.material_of(world.bodies[world.elements.bodies[tet]]));
}

}  // namespace griffith
