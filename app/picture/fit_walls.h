#pragma once

#include "sim/mesh/tet_mesh.h"
#include "sim/meshing/surface.h"
#include "sim/splinters/splinters.h"

namespace griffith::app {

/// Moves the walls of splinters that end on the boundary of their tets onto the original surface, each within its
/// plane, with additional corners along the surface. Everything else stays. Tets and surface are in the same space.
void fit_walls(SplinterSet& splinters, const TetSoup& soup, const TriangleSurface& surface);

}  // namespace griffith::app
