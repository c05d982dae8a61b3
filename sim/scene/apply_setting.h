#pragma once

// For the .cpp files of this folder only, so that the JSON library stays hidden.

#include "sim/scene/json_document.h"
#include "sim/scene/scene_setting.h"

namespace griffith {

/// Returns the value at `pointer` in `document`. Short forms on the way (omitted defaults, materials by name, one
/// number for a vector) are replaced by those of `in_full`, the same scene in full. Throws InputError, which names
/// `file`, if neither has such a field.
Json& value_at(Json& document, const Json& in_full, const std::string& pointer, const std::string& file);

/// Sets the value of a setting. Throws InputError as value_at() does, and for a value that is not JSON.
void apply(const SceneSetting& setting, Json& document, const Json& in_full, const std::string& file);

}  // namespace griffith
