#pragma once

#include "sim/world/state/world_state.h"

namespace griffith {

/// Queues all bursts of the scene. Throws InputError if they make a crowd in one place, or for a surface file that
/// cannot be read or has no volume.
void queue_bursts(WorldState& world);
/// Queues a burst while the scene runs, its start counted from now. Throws InputError likewise and for more projectiles
/// than a scene may have, and then queues nothing. Returns the burst with the points of its surface in its place.
ProjectileBurst fire_burst(WorldState& world, const ProjectileBurst& burst);
/// Adds the shots whose time has come to the contact world.
void launch_projectiles(WorldState& world);

}  // namespace griffith
