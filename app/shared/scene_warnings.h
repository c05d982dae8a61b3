#pragma once

#include <vector>

#include "sim/core/error.h"
#include "sim/world/world.h"

namespace griffith::app {

/// What the user should know about a scene although it runs, by JSON pointers: what building its world found, and what
/// starts inside something else. `world`: of the scene, before its first step.
std::vector<InputError> scene_warnings(const Scene& scene, const World& world);

}  // namespace griffith::app
