#pragma once

#include <span>
#include <string>
#include <vector>

#include "sim/scene/scene.h"
#include "sim/scene/scene_setting.h"

namespace griffith {

/// The settings that make `before` into `after`, each as deep in the scene as it can be: single numbers, but all
/// components of a vector, and all of a list of which the length has changed. Empty where both are written alike.
std::vector<SceneSetting> settings_between(const Scene& before, const Scene& after);

/// The scene with these settings, none within another. Throws InputError, which names `where`, for a field that the
/// scene does not have and for a value that a scene file could not have there.
Scene with_settings(const Scene& scene, std::span<const SceneSetting> settings, const std::string& where);

}  // namespace griffith
