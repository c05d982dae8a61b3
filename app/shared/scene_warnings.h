#pragma once

#include <vector>

#include "sim/core/error.h"
#include "sim/world/world.h"

namespace griffith::app {

/// Returns warnings about a valid scene, by JSON pointers: those from building its world, and initial overlaps.
/// `world`: of the scene, before its first step.
std::vector<InputError> scene_warnings(const Scene& scene, const World& world);

}  // namespace griffith::app
