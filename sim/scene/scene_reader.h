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

// The format is described in scenes/README.md and by scenes/scene.schema.json; scene_fields.h is its table.

/// Reads a scene file. Throws InputError with the first problem: at file#/json/pointer, or at file:line:column when the
/// text is not JSON. `settings` take the place of what the file says, one after the other.
Scene read_scene(const std::filesystem::path& path, std::span<const SceneSetting> settings = {});

/// Reads a scene from text. `where` names the text in errors; relative mesh paths start at `folder` (if empty, at the
/// current one), which becomes Scene::folder. Throws InputError with the first problem.
Scene scene_from_json(std::string_view text, const std::string& where = "scene",
                      const std::filesystem::path& folder = {});
/// As above, but without a look for the files that it names.
Scene scene_from_json_alone(std::string_view text, const std::string& where);

/// Every problem of a scene file, in the order of the document's parts; empty when read_scene() would succeed.
std::vector<InputError> check_scene(const std::filesystem::path& path, std::span<const SceneSetting> settings = {});

/// What a scene file says in words that are read but are others today, and how to write it; nothing where it cannot be
/// read.
std::vector<InputError> outdated_names(const std::filesystem::path& path);

/// Every problem of a scene's text, but without a look for its mesh files.
std::vector<InputError> check_scene_text(std::string_view text, const std::string& where);

}  // namespace griffith
