#pragma once

#include <filesystem>
#include <span>

#include "sim/core/error.h"
#include "sim/world/world.h"

namespace griffith::app {

/// Prints warnings to stderr, the first twenty in full. Places without a file get `scene_file`.
void print_warnings(const std::filesystem::path& scene_file, std::span<const InputError> warnings);

/// Opens a scene for a command: make_world() with progress on the terminal, then prints the warnings of its world.
World open_world(const Scene& scene, const std::filesystem::path& scene_file);

}  // namespace griffith::app
