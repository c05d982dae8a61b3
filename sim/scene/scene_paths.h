#pragma once

#include <filesystem>
#include <vector>

#include "sim/scene/scene.h"

namespace griffith {

/// All paths in the scene that a world is built from files by: of bodies, splinters and projectiles, in this order.
std::vector<std::filesystem::path*> paths_in(Scene& scene);

}  // namespace griffith
