#pragma once

#include <string>

#include "app/bake/bake.h"

namespace griffith::app {

/// Returns a binary glTF 2.0 file of the bake: one node for each object, with a mesh of up to two materials, and one
/// animation with tracks for moving objects. Time 0 is the first frame. Objects that appear later have scale 0 before.
/// Deformed points are morph targets, one for each frame. Extras of nodes contain mass, break time, scene body and
/// bonds.
std::string glb_file(const Bake& bake);

}  // namespace griffith::app
