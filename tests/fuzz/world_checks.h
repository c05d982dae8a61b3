#pragma once

#include "sim/scene/scene.h"

namespace griffith::fuzz {

/// Builds a world of the scene and takes some steps, fewer of a large one. Throws BrokenPromise when a value is not
/// finite, when mass changes, when energy or momentum appears from nowhere or when the mesh is no longer sound.
/// `has_slivers`: needles spin up where they touch, so their energy is not looked at.
void run_world(const Scene& scene, int max_steps, bool has_slivers = false);

}  // namespace griffith::fuzz
