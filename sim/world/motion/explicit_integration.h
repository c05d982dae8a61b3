#pragma once

#include "sim/world/state/world_state.h"

namespace griffith {

/// Returns the longest stable substep for explicit integration of all elastic bodies in their present state [s].
/// Freezes bodies that would exceed the limit of substeps, as those with slivers may.
double stable_substep(WorldState& world);
/// Throws InputError if the pieces of a scene body, of this material, would exceed the limit of substeps.
void check_substep_count(const WorldState& world, int scene_body, const Material& material);
/// Computes the velocities of a body by explicit integration; `forces` contain the elastic and external ones.
void predict_explicitly(WorldState& world, Body& body, std::vector<Vec3>& forces, double dt);

}  // namespace griffith
