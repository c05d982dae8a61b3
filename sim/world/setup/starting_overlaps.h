#pragma once

#include <vector>

#include "sim/core/error.h"
#include "sim/scene/scene.h"
#include "sim/world/frame.h"

namespace griffith {

/// Bodies of a scene that start under the ground or inside one another, by their collision shapes: named, with how far,
/// the deepest first. `start` is the frame before the first step. A scene runs with them, but they are pushed apart.
std::vector<InputError> starting_overlaps(const Scene& scene, const Frame& start);

}  // namespace griffith
