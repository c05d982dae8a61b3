#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "sim/core/error.h"
#include "sim/scene/scene.h"
#include "sim/scene/scene_setting.h"

namespace griffith {

// The format is described in scenes/README.md and by scenes/scene.schema.json, which follow from scene_fields.h.

/// Reads a scene file. `settings` replace values of the file, one after the other. Throws InputError with the first
/// problem: at file#/json/pointer, or at file:line:column if the text is not JSON.
Scene read_scene(const std::filesystem::path& path, std::span<const SceneSetting> settings = {});

/// Reads a scene from text. `where` names the text in errors. Relative mesh paths start at `folder` (if empty, at the
/// current one), which becomes Scene::folder. Throws InputError with the first problem.
Scene scene_from_json(std::string_view text, const std::string& where = "scene",
                      const std::filesystem::path& folder = {});
/// As above, but does not check that files exist.
Scene scene_from_json_alone(std::string_view text, const std::string& where);

/// Returns every problem of a scene file, in the order of the document's parts; empty if read_scene() would succeed.
std::vector<InputError> check_scene(const std::filesystem::path& path, std::span<const SceneSetting> settings = {});

/// Returns the outdated names in a scene file with their replacements; none if it cannot be read.
std::vector<InputError> outdated_names(const std::filesystem::path& path);

/// Returns every problem of a scene's text, but does not check that mesh files exist.
std::vector<InputError> check_scene_text(std::string_view text, const std::string& where);

}  // namespace griffith
