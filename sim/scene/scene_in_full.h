#pragma once

// For the .cpp files of this folder alone: nothing else sees the JSON library.

#include "sim/scene/json_document.h"
#include "sim/scene/scene.h"

namespace griffith {

/// The scene as a document that leaves nothing out: every field with its value, each body's material as an object.
Json scene_in_full(const Scene& scene);

}  // namespace griffith
