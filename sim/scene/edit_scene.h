#pragma once

#include <span>
#include <string>

#include "sim/scene/scene.h"
#include "sim/scene/scene_setting.h"

namespace griffith {

/// Returns the scene with the settings applied. Throws InputError, with `where` before the JSON pointer of the first
/// problem, if the result is not a valid scene. Does not check that mesh files exist.
Scene edited(const Scene& scene, std::span<const SceneSetting> settings, const std::string& where = "scene");

/// Returns the JSON text of the value at a JSON pointer (RFC 6901), defaults included; "" is the whole scene. Throws
/// InputError if there is no such field.
std::string value_of(const Scene& scene, const std::string& pointer, const std::string& where = "scene");

}  // namespace griffith
