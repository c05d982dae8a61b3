#pragma once

#include "renderer/draw_scene.h"

namespace griffith::render {

/// A brick-patterned wall of boxes with a hole, debris, two spheres, a line and a point on the ground: something of
/// everything. Triangle ids count from 0; the spheres' ids are 1000001 and 1000002.
DrawScene wall_scene();

/// The wall with a smooth scalar in [0, 1] per corner.
DrawScene scalar_wall_scene();

inline constexpr std::int32_t kBallId = 1000001;

}  // namespace griffith::render
