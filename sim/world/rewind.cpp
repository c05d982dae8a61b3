#include "sim/world/rewind.h"

#include <algorithm>

#include "sim/world/phases.h"

namespace griffith {
namespace {

void rewind_piece(WorldState& world, Body& body, const Moment::Piece& piece) {
  body.motion = piece.motion;
  body.orientation = piece.orientation;
  body.softened = piece.softened;
  body.softening = piece.softening;
  body.last_strike = piece.last_strike;
  if (piece.rigid && !body.rigid) place_rigid_nodes(world, body);
}

}  // namespace

Moment moment_of(const WorldState& world) {
  Moment moment;
  moment.time = world.time;
  moment.positions = world.nodes.positions;
  moment.velocities = world.nodes.velocities;
  moment.separations = world.nodes.separations;
  moment.states = world.elements.states;
  moment.plastic_strains = world.elements.plastic_strains;
  moment.stresses = world.elements.stresses;
  for (const Body& body : world.bodies)
    moment.pieces.push_back(
        {body.motion, body.orientation, body.rigid, body.softened, body.softening, body.last_strike});
  for (const Projectile& projectile : world.projectiles)
    moment.projectiles.push_back(world.contact_world.state(projectile.object));
  moment.contact_views = world.contact_views.size();
  moment.energy = world.energy;
  return moment;
}

void rewind(WorldState& world, const Moment& moment, std::span<const NodeCopy> cracked) {
  NodeArrays& nodes = world.nodes;
  world.time = moment.time;
  std::ranges::copy(moment.positions, nodes.positions.begin());
  std::ranges::copy(moment.velocities, nodes.velocities.begin());
  std::ranges::copy(moment.separations, nodes.separations.begin());
  world.elements.states = moment.states;
  world.elements.plastic_strains = moment.plastic_strains;
  world.elements.stresses = moment.stresses;
  for (std::size_t i = 0; i < moment.pieces.size(); ++i) rewind_piece(world, world.bodies[i], moment.pieces[i]);
  for (const NodeCopy& copy : cracked) {
    nodes.positions[copy.copy] = Vec3(nodes.positions[copy.original]);
    nodes.velocities[copy.copy] = Vec3(nodes.velocities[copy.original]);
    nodes.separations[copy.original] = nodes.separations[copy.copy] = {};
  }
  for (std::size_t i = 0; i < moment.pieces.size(); ++i)
    if (moment.pieces[i].rigid && !world.bodies[i].rigid) update_elements(world, world.bodies[i]);
  for (std::size_t i = 0; i < moment.projectiles.size(); ++i)
    world.contact_world.set_state(world.projectiles[i].object, moment.projectiles[i]);
  world.contact_views.resize(moment.contact_views);
  const EnergyAccount cracked_since = world.energy;
  world.energy = moment.energy;
  world.energy.crack_area = cracked_since.crack_area;
  world.energy.fracture_energy = cracked_since.fracture_energy;
}

}  // namespace griffith
