#pragma once

#include <string>

#include "sim/world/world_state.h"

namespace griffith {

/// Queues the shots of a burst, its start counted from now. Throws InputError, about the field `where` of the scene,
/// for a surface file that cannot be read or has no volume.
void queue_burst(WorldState& world, const ProjectileBurst& burst, const std::string& where);
/// All bursts of the scene. Throws InputError where they make a crowd in one place.
void queue_bursts(WorldState& world);
/// A burst while the scene runs. Throws InputError, with nothing queued, as queue_burst() does, for a crowd, and where
/// there would be more projectiles than a scene may have.
/// Returns the burst with the points of its surface in place of that.
ProjectileBurst fire_burst(WorldState& world, const ProjectileBurst& burst);
/// Puts the shots whose time has come into the contact world.
void launch_projectiles(WorldState& world);

}  // namespace griffith
