#pragma once

#include <span>
#include <string>

#include "sim/scene/scene.h"
#include "sim/scene/scene_setting.h"

namespace griffith {

/// The scene with the settings in place of the values that it has. Throws InputError, with `where` before the JSON
/// pointer of the first problem, where the result is no valid scene. Mesh files are not looked for.
Scene edited(const Scene& scene, std::span<const SceneSetting> settings, const std::string& where = "scene");

/// The JSON text of what the scene has at a JSON pointer (RFC 6901), defaults included; "" is the whole scene. Throws
/// InputError where there is no such field.
std::string value_of(const Scene& scene, const std::string& pointer, const std::string& where = "scene");

}  // namespace griffith
