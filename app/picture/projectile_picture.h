#pragma once

#include "renderer/draw_scene.h"
#include "sim/world/output/frame.h"

namespace griffith::app {

/// Adds a frame's projectiles to a picture. Balls look like a material of their density, other shapes only if the
/// picture is `natural`, that is, shows materials.
void add_projectiles(const Frame& frame, bool natural, render::DrawScene& picture);

}  // namespace griffith::app
