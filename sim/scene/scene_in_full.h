#pragma once

// For the .cpp files of this folder only, so that the JSON library stays hidden.

#include "sim/scene/json_document.h"
#include "sim/scene/scene.h"

namespace griffith {

/// Returns the scene as a complete document: every field with its value, each body's material as an object.
Json scene_in_full(const Scene& scene);

}  // namespace griffith
