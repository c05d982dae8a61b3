#include "sim/world/overload.h"

#include <algorithm>

#include "sim/world/bodies/bodies.h"
#include "sim/world/energy/energy_phase.h"
#include "sim/world/explicit/explicit_regime.h"
#include "sim/world/explicit/similarity.h"
#include "sim/world/fracture/fracture_phase.h"
#include "sim/world/impacts/struck_bodies.h"

namespace griffith {
namespace {

/// Utilization up to which cracks begin in time.
constexpr double kInTime = 1.01;

/// Returns the utilization of a node by its load at the end of the last substep, not by the mean of start and end.
double utilization_at_end(const WorldState& world, NodeId node) {
  const NodeSeparation& separation = world.nodes.separations[node];
  const double end_over_mean = separation.stress > 0 ? separation.end_stress / separation.stress : 1;
  return end_over_mean * separation.utilization;
}

/// True if one of the nodes of a deformable body may crack, has `is_overloaded`, and its waves can be followed.
template <class IsOverloaded>
bool may_crack_in_microsteps(const WorldState& world, const Body& body, IsOverloaded is_overloaded) {
  const auto cracks = [&](NodeId node) { return is_overloaded(node) && may_crack(world, node); };
  return body.is_deformable() && std::ranges::any_of(body.nodes, cracks) && suits_microsteps(world, body, 0);
}

/// Returns the highest utilization of a body's nodes that may crack, by the load at the end of the last substep.
double highest_utilization(const WorldState& world, const Body& body) {
  double highest = 0;
  for (const NodeId node : body.nodes)
    if (may_crack(world, node)) highest = std::max(highest, utilization_at_end(world, node));
  return highest;
}

/// Returns the energy that an object loses where a force stops it evenly in a substep `dt` [s] at whose end it acts
/// [J].
double lost_in_stop(const WorldState& world, const ContactLoad& load, double dt) {
  const std::optional<RigidMass> moved = world.contact_world.rigid_mass(load.other);
  const BodyId id = world.body_of(load.other);
  const double mass = moved                                         ? moved->mass
                      : id.valid() && !world.bodies[id].supported() ? world.bodies[id].motion.mass
                                                                    : 0;
  return mass > 0 ? 0.5 * (dt * load.force).squaredNorm() / mass : 0;
}

/// Returns the energy that the last implicit substep `dt` [s] took by its damping from a body and from what it touches
/// [J]. At a high load, forces at rest count as if they had stopped what they act on: they may just have begun.
/// `is_low`: the load is not high.
double damped_energy(const WorldState& world, const Body& body, double dt, bool is_low) {
  double energy = world.scratch.bodies[body.id].damped;
  for (const ContactLoad& load : body.known_contact_loads) {
    const double stopped = is_low ? 0 : lost_in_stop(world, load, dt);
    energy += is_thin(body) ? std::max(load.lost_in_impact, stopped) : stopped;
  }
  return energy;
}

/// True if a body suited to microsteps would have been overloaded with the energy that the damping of the implicit
/// substep took. Stress grows with the root of the energy. `shortest`: substep below which stout bodies are not asked.
bool is_held_by_damping(const WorldState& world, const Body& body, double dt, double shortest) {
  // Of the resistance: of less load, damping says little about the stress. Thin bodies bend for longer than a step.
  constexpr double kLoaded = 0.3, kBent = 0.03;
  if (!body.is_deformable() || body.id.index() >= static_cast<int>(world.scratch.bodies.size())) return false;
  if (!is_thin(body) && dt < 2 * shortest) return false;
  const double utilization = highest_utilization(world, body);
  if (utilization < (is_thin(body) ? kBent : kLoaded) || utilization > 1) return false;
  const double elastic = elastic_energy(world, body), damped = damped_energy(world, body, dt, utilization < kLoaded);
  return utilization * utilization * (elastic + damped) > elastic && suits_microsteps(world, body, 0);
}

}  // namespace

bool may_overload(const WorldState& world) {
  return world.model->scene.simulation.fracture && !any_explicit(world) && !is_spent(world) &&
         std::ranges::any_of(world.bodies, &Body::is_deformable);
}

double fraction_until_overload(const WorldState& before, const WorldState& world, double last_over_this) {
  // The stress at the end of a substep answers to its mean load: to the load at its middle.
  const auto rise_of = [&](NodeId node) {
    return (utilization_at_end(world, node) - utilization_at_end(before, node)) * 2 / (1 + last_over_this);
  };
  const auto is_late = [&](NodeId node) {
    const bool is_new = node.index() >= static_cast<int>(before.nodes.separations.size());  // copy beside a crack
    return !is_new && utilization_at_end(world, node) + 0.5 * rise_of(node) > kInTime;
  };
  double fraction = 1;
  for (const Body& body : world.bodies) {
    if (!may_crack_in_microsteps(world, body, is_late)) continue;
    for (const NodeId node : body.nodes) {
      if (!is_late(node) || !may_crack(world, node)) continue;
      const double until = 1 - utilization_at_end(world, node);
      fraction = std::min(fraction, rise_of(node) > 0 ? 0.5 + until / rise_of(node) : 0);
    }
  }
  return fraction;
}

bool may_be_held_by_damping(const WorldState& world, double dt, double shortest) {
  return std::ranges::any_of(world.bodies,
                             [&](const Body& body) { return is_held_by_damping(world, body, dt, shortest); });
}

void begin_explicit_if_overloaded(WorldState& world) {
  if (!world.model->scene.simulation.fracture || is_spent(world)) return;
  const auto is_overloaded = [&](NodeId node) { return world.nodes.separations[node].utilization > 1; };
  for (Body& body : world.bodies)
    if (may_crack_in_microsteps(world, body, is_overloaded)) begin_explicit(world, body, 0);
}

}  // namespace griffith
