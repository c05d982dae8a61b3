#pragma once

#include <vector>

#include "app/picture/element_picture.h"
#include "renderer/draw_scene.h"

namespace griffith::app {

/// Returns lines where cracks reach the surface of a piece that is still connected around them: edges of `triangles`
/// that coincide at rest, belong to one piece and have different nodes. Without these lines, cracks that have hardly
/// opened would be invisible.
std::vector<render::Line> crack_lines(const std::vector<PictureTriangle>& triangles, const ShownMesh& shown);

}  // namespace griffith::app
