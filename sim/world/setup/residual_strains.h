#pragma once

#include "sim/world/state/world_state.h"

namespace griffith {

/// Gives the tets of a scene body with residual stress their strain without stress, under the material in force. Call
/// it before anything has moved. Throws InputError for a file that cannot be used.
void set_residual_strains(const WorldState& world, int scene_body, ElementArrays& elements);
/// Throws an InputError if a scene body has residual stress and its material yields.
void check_residual_stress(const Scene& scene, int scene_body, const Material& material);
/// Removes all plastic strain of a scene body. Residual strains follow the material in force; those from a file stay.
void reset_residual_strains(const WorldState& world, int scene_body, ElementArrays& elements);

}  // namespace griffith
