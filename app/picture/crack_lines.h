#pragma once

#include <vector>

#include "app/picture/element_picture.h"
#include "renderer/draw_scene.h"

namespace griffith::app {

/// Lines where cracks come to the surface of a piece that still holds together on both sides of them: edges of
/// `triangles` that lie on each other at rest, belong to one piece and have different nodes. Nothing else would show
/// cracks that have hardly opened.
std::vector<render::Line> crack_lines(const std::vector<PictureTriangle>& triangles, const ShownMesh& shown);

}  // namespace griffith::app
