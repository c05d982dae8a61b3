#pragma once

#include <string>

#include "sim/world/world_state.h"

namespace griffith {

/// Queues the shots of a burst, its start counted from now. Throws InputError, about the field `where` of the scene,
/// for a surface file that cannot be read or has no volume.
void queue_burst(WorldState& world, const ProjectileBurst& burst, const std::string& where);
/// Queues all bursts of the scene. Throws InputError if they make a crowd in one place.
void queue_bursts(WorldState& world);
/// Queues a burst while the scene runs. Throws InputError like queue_burst(), and queues nothing, for a crowd and for
/// more projectiles than a scene may have. Returns the burst with the points of its surface in its place.
ProjectileBurst fire_burst(WorldState& world, const ProjectileBurst& burst);
/// Adds the shots whose time has come to the contact world.
void launch_projectiles(WorldState& world);

}  // namespace griffith
