#pragma once

#include <filesystem>
#include <vector>

#include "sim/scene/scene.h"

namespace griffith {

/// Returns all paths in the scene to files that a world is built from: of bodies, splinters and projectiles, in this
/// order.
std::vector<std::filesystem::path*> paths_in(Scene& scene);

/// Returns the path by which a scene in `folder` names a file, so that both can be moved together. An empty folder,
/// that of a scene without a file, stands for the working folder.
std::filesystem::path path_from_scene(const std::filesystem::path& file, const std::filesystem::path& folder);

}  // namespace griffith
