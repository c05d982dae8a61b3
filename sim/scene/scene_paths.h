#pragma once

#include <filesystem>
#include <vector>

#include "sim/scene/scene.h"

namespace griffith {

/// Returns all paths in the scene to files that a world is built from: of bodies, splinters and projectiles, in this
/// order.
std::vector<std::filesystem::path*> paths_in(Scene& scene);

}  // namespace griffith
