#pragma once

#include <filesystem>

#include "sim/core/error.h"
#include "sim/world/world.h"

namespace griffith::app {

/// Returns the error with the scene's file before its place, if the place is only a JSON pointer: a world does not know
/// its file.
InputError in_file(const std::filesystem::path& scene_file, const InputError& error);

/// Builds the world of a scene that was read from `scene_file` (empty: from none). Errors name the file.
World make_world(const Scene& scene, const std::filesystem::path& scene_file, const Monitor& monitor);
/// As above, with progress on the terminal.
World make_world(const Scene& scene, const std::filesystem::path& scene_file);

}  // namespace griffith::app
