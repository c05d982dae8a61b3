#pragma once

#include <vector>

#include "sim/core/error.h"
#include "sim/scene/scene.h"
#include "sim/world/output/frame.h"

namespace griffith {

/// Returns the bodies of a scene that start below the ground or inside one another, by their collision shapes, with
/// their depths, the deepest first. `start` is the frame before the first step. The scene still runs, and they are
/// pushed apart.
std::vector<InputError> starting_overlaps(const Scene& scene, const Frame& start);

}  // namespace griffith
