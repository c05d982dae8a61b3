#pragma once

#include <string>

namespace griffith {

/// Returns the JSON Schema (2020-12) of scene files, scenes/scene.schema.json, made from the table that the reader
/// follows. Text editors use it to complete and check scenes. It cannot express further checks of the reader: unique
/// names, existing meshes, and conditions between two fields.
std::string scene_schema();

}  // namespace griffith
