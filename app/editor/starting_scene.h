#pragma once

#include "sim/scene/scene.h"

namespace griffith::app {

/// What the editor shows when no scene is named: a brick wall on the ground, waiting to be shot at.
Scene starting_scene();

}  // namespace griffith::app
