#pragma once

#include "app/picture/shown_mesh.h"
#include "renderer/camera.h"

namespace griffith::app {

/// Returns the corner of a tet nearest to the point where a ray enters it. If the ray misses the tet (its splinters may
/// be drawn elsewhere), the corner nearest to the ray.
NodeId nearest_corner(const ShownMesh& shown, TetId tet, const render::Ray& ray);

}  // namespace griffith::app
