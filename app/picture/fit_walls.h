#pragma once

#include "app/picture/placed_tets.h"
#include "sim/meshing/surface.h"
#include "sim/splinters/splinters.h"

namespace griffith::app {

/// Moves the walls of splinters that end on the boundary of their tets on to the surface that these were filled from,
/// each in its plane, with corners between so that it follows the surface. All else of the splinters stays. Tets and
/// surface are in one space.
void fit_walls(SplinterSet& splinters, const PlacedTets& placed, const TriangleSurface& surface);

}  // namespace griffith::app
