#include <algorithm>
#include <set>
#include <utility>

#include "sim/elasticity/principal_stress.h"
#include "sim/world/phases.h"

namespace griffith {
namespace {

/// Fewer tets are debris, whose mesh has no room for waves: knocks at its corners, spread over it, would be read
/// several times too hard.
constexpr std::size_t kFewestTets = 20;

/// Ascending.
std::set<BodyId> struck_bodies(const WorldState& world) {
  std::set<BodyId> struck;
  for (const Contact& contact : world.contact_world.contacts())
    for (ProxyId side : {contact.a, contact.b}) {
      const BodyId id = world.body_of(side);
      if (id.valid() && !world.bodies[id].rigid && strikes(world, contact, world.bodies[id])) struck.insert(id);
    }
  return struck;
}

int moving_tets(const WorldState& world) {
  std::size_t count = 0;
  for (const Body& body : world.bodies) count += body.rigid ? 0 : body.tets.size();
  return static_cast<int>(count);
}

/// Softened from now to the end of the step.
void soften(WorldState& world, Body& body) {
  body.softened = SoftenedImpact{};
  body.softened->wanted_substep = impact_substep(world, body);
  body.softened->substeps = world.coarse_impact->substeps_left;
  body.softened->tets = moving_tets(world);
  for (TetId tet : body.tets) world.elements.stresses_before[tet] = world.elements.states[tet].stress;
}

/// What a body withstands in a substep of this length [s]; of the step's substeps the softest is kept for the frame.
void take_substep(const WorldState& world, Body& body, double substep) {
  const Material& material = world.material_of(body);
  body.softening = softening_factor(world, body, substep);
  if (body.softening >= body.softened->factor) return;
  body.softened->factor = body.softening;
  body.softened->young_modulus = body.softening * body.softening * material.young_modulus;
  body.softened->tensile_strength = body.softening * material.tensile_strength;
  body.softened->substep = substep;
}

}  // namespace

double softening_factor(const WorldState& world, const Body& body, double substep) {
  if (body.tets.size() < kFewestTets) return 1;
  const double wave_speed = bar_wave_speed(world.material_of(body));
  return softening_factor(wave_speed, body.extent, substep, impact_substep(world, body));
}

bool strikes(const WorldState& world, const Contact& contact, const Body& body) {
  return !contact.impulse.isZero(0) && contact.approach > least_impact_speed(world) &&
         contact.approach > hurting_speed(world, body);
}

void soften_struck_bodies(WorldState& world, double substep) {
  for (const BodyId id : struck_bodies(world)) {
    Body& body = world.bodies[id];
    const bool goes_on = body.last_strike >= world.step - 1;
    body.last_strike = world.step;
    const bool too_long = world.coarse_impact && world.coarse_impact->substep > impact_substep(world, body);
    if (too_long && !goes_on && body.tets.size() >= kFewestTets) soften(world, body);
  }
  for (Body& body : world.bodies) {
    body.softened_before = body.softening < 1;
    body.softening = 1;
    if (body.softened && !body.rigid) take_substep(world, body, substep);
  }
}

std::vector<ElementState> softened_states(const WorldState& world) {
  std::vector<ElementState> states = world.elements.states;
  for (const Body& body : world.bodies) {
    if (body.softening == 1) continue;
    for (TetId tet : body.tets) {
      const Mat3& before = world.elements.stresses_before[tet];
      states[tet].stress = before + (states[tet].stress - before) / body.softening;
      states[tet].tensile_stress = tensile_part(states[tet].stress);
    }
  }
  return states;
}

}  // namespace griffith
