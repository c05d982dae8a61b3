#pragma once

#include "sim/world/world_state.h"

namespace griffith {

/// The longest substep in which explicit integration of all elastic bodies, as they are now, is stable [s]. Freezes
/// bodies that would take more substeps a step than it makes, as those may that have slivers.
double stable_substep(WorldState& world);
/// Throws InputError where the pieces of a scene body, of this material, would take more substeps a step than explicit
/// integration makes.
void check_substep_count(const WorldState& world, int scene_body, const Material& material);
/// Velocities of a body by explicit integration; `forces` hold the elastic and external ones.
void predict_explicitly(WorldState& world, Body& body, std::vector<Vec3>& forces, double dt);

}  // namespace griffith
