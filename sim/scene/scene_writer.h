#pragma once

#include <filesystem>
#include <string>

#include "sim/scene/scene.h"

namespace griffith {

/// Returns the scene as JSON text. Reading it back gives the same scene, to the last bit of every number, with the
/// materials of its bodies among its own. Defaults are omitted; materials are written in full, once each. Throws
/// InputError if a text is not UTF-8.
std::string scene_to_json(const Scene& scene);

/// Returns the scene with paths relative to another folder, absolute, that name the same files.
Scene with_paths_from(Scene scene, const std::filesystem::path& folder);

/// Writes the scene file beside its target and renames it, so that an interruption loses nothing. Relative paths are
/// rewritten relative to the new folder. Throws InputError if the file cannot be written or the scene has a value that
/// read_scene() would reject; an older file is then unchanged.
void write_scene(const Scene& scene, const std::filesystem::path& path);

}  // namespace griffith
