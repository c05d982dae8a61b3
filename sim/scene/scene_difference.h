#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "sim/scene/scene.h"
#include "sim/scene/scene_setting.h"

namespace griffith {

/// The settings that make `before` into `after`, each as deep in the scene as it can be: single numbers, but all
/// components of a vector, and all of a list of which the length has changed. Empty where both are written alike.
std::vector<SceneSetting> settings_between(const Scene& before, const Scene& after);

/// A field in which two scenes differ.
struct FieldChange {
  std::string pointer;                       ///< JSON pointer, of the later scene where it has the field
  std::optional<std::string> before, after;  ///< as JSON; absent where that scene has no such field

  bool operator==(const FieldChange&) const = default;
};

/// The scene as JSON text with every field, also those that have their defaults, to be compared later.
std::string full_scene_text(const Scene& scene);

/// The fields in which two full_scene_text()s differ, of whatever versions of the program: single numbers, but whole
/// vectors. Items of lists that have names are compared by these. Throws InputError for what is no JSON.
std::vector<FieldChange> field_changes(const std::string& before, const std::string& after);

/// The scene with these settings, none within another. Throws InputError, which names `where`, for a field that the
/// scene does not have and for a value that a scene file could not have there.
Scene with_settings(const Scene& scene, std::span<const SceneSetting> settings, const std::string& where);

}  // namespace griffith
