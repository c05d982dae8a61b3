#pragma once

#include "sim/scene/scene.h"

namespace griffith::app {

/// Returns the default scene: a brick wall on the ground.
Scene starting_scene();

}  // namespace griffith::app
