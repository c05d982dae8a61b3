#pragma once

#include <filesystem>
#include <span>

#include "sim/core/error.h"
#include "sim/world/world.h"

namespace griffith::app {

/// Prints warnings to the standard error output, the first twenty in full. Places without a file get `scene_file`.
void print_warnings(const std::filesystem::path& scene_file, std::span<const InputError> warnings);

/// As make_world() on the terminal, then prints the findings of its world: a command's way to open a scene.
World open_world(const Scene& scene, const std::filesystem::path& scene_file);

}  // namespace griffith::app
