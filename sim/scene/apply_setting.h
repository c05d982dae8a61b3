#pragma once

// For the .cpp files of this folder alone: nothing else sees the JSON library.

#include "sim/scene/json_document.h"
#include "sim/scene/scene_setting.h"

namespace griffith {

/// The value at `pointer` in `document`, whose short forms on the way there (defaults left out, materials by name, one
/// number for a vector) are replaced by what `in_full`, the same scene with nothing left out, has there. Throws
/// InputError, which names `file`, where neither has such a field.
Json& value_at(Json& document, const Json& in_full, const std::string& pointer, const std::string& file);

/// Puts the setting's value at its place. Throws InputError as value_at() does, and for a value that is no JSON.
void apply(const SceneSetting& setting, Json& document, const Json& in_full, const std::string& file);

}  // namespace griffith
