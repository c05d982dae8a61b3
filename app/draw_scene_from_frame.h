#pragma once

#include <cstdint>
#include <vector>

#include "renderer/draw_scene.h"
#include "sim/scene/scene.h"
#include "sim/world/frame.h"

namespace griffith::app {

/// Bit i of an entry: face i of that tet lies on the surface.
using SurfaceFaces = std::vector<std::uint8_t>;

/// The faces without a neighbour. Those of the first frame are what is not a crack.
SurfaceFaces surface_faces(const Frame& frame);

/// The picture of a frame: surface coloured by view.quantity (the body's own colour for "body"), cracks and `selected`
/// marked, projectiles, ground. A triangle's id is its tet.
render::DrawScene draw_scene_from_frame(const Frame& frame, const SurfaceFaces& initial_faces, const Scene& scene,
                                        const ViewSettings& view, TetId selected);

}  // namespace griffith::app
