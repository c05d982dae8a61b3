#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "sim/scene/scene.h"
#include "sim/scene/scene_setting.h"

namespace griffith {

/// Returns the settings that turn `before` into `after`, each as deep in the scene as possible: single numbers, but all
/// components of a vector, and all items of a list whose length has changed. Empty if both are written alike.
std::vector<SceneSetting> settings_between(const Scene& before, const Scene& after);

/// Field that differs between two scenes.
struct FieldChange {
  std::string pointer;                       ///< JSON pointer, in the later scene if it has the field
  std::optional<std::string> before, after;  ///< values as JSON; absent if that scene has no such field

  bool operator==(const FieldChange&) const = default;
};

/// Returns the scene as JSON text with every field, including defaults, for later comparison.
std::string full_scene_text(const Scene& scene);

/// Returns the fields that differ between two full_scene_text()s, of any versions of the program: single numbers, but
/// whole vectors. Named items of lists are compared by name. Throws InputError if a text is not JSON.
std::vector<FieldChange> field_changes(const std::string& before, const std::string& after);

/// Returns the scene with these settings, none within another. Throws InputError, which names `where`, for an unknown
/// field and for a value that a scene file could not have there.
Scene with_settings(const Scene& scene, std::span<const SceneSetting> settings, const std::string& where);

}  // namespace griffith
