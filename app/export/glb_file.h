#pragma once

#include <string>

#include "app/bake/bake.h"

namespace griffith::app {

/// A binary glTF 2.0 file of the bake: a node a thing, with a mesh of up to two materials, and one animation with
/// tracks where things move. Time 0 is the first frame. Things that appear later have scale 0 before. Deformed points
/// are morph targets, one a frame. Extras of nodes tell mass, break time, scene body and bonds.
std::string glb_file(const Bake& bake);

}  // namespace griffith::app
