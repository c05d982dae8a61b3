#pragma once

#include <functional>
#include <vector>

#include "sim/world/energy/energy_phase.h"
#include "sim/world/state/world_state.h"

namespace griffith {

/// Moves the proxies to their bodies: after bodies move, so that impacts are predicted from the present places.
void place_proxies(WorldState& world);
/// Returns the external forces: gravity and the mean of the loads over the next substep of `dt` [s] [N].
ExternalForces external_forces(const WorldState& world, double dt);
/// Makes ballistic bodies elastic that an impact reaches within `duration` [s].
void make_first_struck_elastic(WorldState& world, double duration);
/// Finds all contacts within a substep of `dt` [s], and the bodies that are quasi-static in it.
void find_contacts(WorldState& world, double dt);
/// Removes the meetings within a substep that its owner follows by microsteps afterwards: the others become contacts.
using MeetingFilter = std::function<void(const WorldState&, std::vector<ContactWorld::Meeting>&)>;
/// Changes the velocities so that nothing penetrates, and moves the projectiles. `external`: forces per node [N].
/// Returns how bodies move with these velocities, by BodyId: by a nonlinear step what strains far.
std::vector<ElasticMove> resolve_contacts(WorldState& world, const std::vector<Vec3>& external, double dt,
                                          const MeetingFilter& leave);

}  // namespace griffith
