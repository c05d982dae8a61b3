#pragma once

#include <filesystem>
#include <string>

#include "sim/scene/scene.h"

namespace griffith {

/// The scene as JSON text. Reading it back gives the same scene, to the last bit of every number, with the materials of
/// its bodies among its own. What equals its default is left out; materials are written in full, each once. Throws
/// InputError when a text is not UTF-8.
std::string scene_to_json(const Scene& scene);

/// Returns the scene with paths that lead from another folder, absolute, to the same files.
Scene with_paths_from(Scene scene, const std::filesystem::path& folder);

/// Writes the scene file, beside its target first and then renamed, so that an interruption loses nothing. Relative
/// paths are rewritten to lead from the new folder to the same files. Throws InputError when the file cannot be
/// written and when the scene has a value that read_scene() would refuse; an older file then stays as it was.
void write_scene(const Scene& scene, const std::filesystem::path& path);

}  // namespace griffith
