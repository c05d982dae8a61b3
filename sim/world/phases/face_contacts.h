#pragma once

#include "sim/world/world_state.h"

namespace griffith {

/// Where an elastic body lies on the ground, or a face of it on that of another body, puts contacts at all nodes there,
/// of both, in the place of the few of their proxies: so a face carries its load over its nodes. Distances are those
/// of the surfaces as they are deformed. Pieces that a crack has just parted are left alone. Pairs that have such
/// contacts already keep them. Nodes that may reach the ground in a substep of `dt` [s] are foreseen.
void spread_contacts(WorldState& world, double dt);

}  // namespace griffith
