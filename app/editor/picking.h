#pragma once

#include "app/picture/shown_mesh.h"
#include "renderer/camera.h"

namespace griffith::app {

/// The corner of a tet that a ray through it points at: the nearest to where the ray enters or, where it passes beside
/// it (what it carries is drawn elsewhere), the nearest to the ray.
NodeId nearest_corner(const ShownMesh& shown, TetId tet, const render::Ray& ray);

}  // namespace griffith::app
