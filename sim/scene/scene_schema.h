#pragma once

#include <string>

namespace griffith {

/// The JSON Schema (2020-12) of scene files, made from the table that the reader follows: scenes/scene.schema.json.
/// Editors complete and check scenes by it. It cannot say what the reader checks besides: names that differ, meshes
/// that exist, and requirements between two fields.
std::string scene_schema();

}  // namespace griffith
