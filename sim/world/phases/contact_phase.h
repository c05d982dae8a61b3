#pragma once

#include <vector>

#include "sim/world/world_state.h"

namespace griffith {

/// Puts the proxies where their bodies are: after bodies move, so that impacts are foreseen from where they are now.
void place_proxies(WorldState& world);
/// External force on each node: gravity and the mean of the loads over a substep of `dt` [s] from now [N].
std::vector<Vec3> external_forces(const WorldState& world, double dt);
/// Bodies that nothing has touched yet become elastic where something strikes them within `duration` [s].
void make_first_struck_elastic(WorldState& world, double duration);
/// Finds all contacts within a substep of `dt` [s], and the bodies that are quasi-static in it.
void find_contacts(WorldState& world, double dt);
/// Changes the velocities so that nothing penetrates; moves the projectiles.
void resolve_contacts(WorldState& world, double dt);

}  // namespace griffith
