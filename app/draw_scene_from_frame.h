#pragma once

#include "renderer/draw_scene.h"
#include "sim/scene/scene.h"
#include "sim/world/frame.h"

namespace griffith::app {

/// The picture of a frame: surface coloured by view.quantity (the body's own colour for "body"), cracks and `selected`
/// marked, projectiles, ground. A triangle's id is its tet.
render::DrawScene draw_scene_from_frame(const Frame& frame, const Scene& scene, const ViewSettings& view,
                                        TetId selected);

}  // namespace griffith::app
