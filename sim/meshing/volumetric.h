#pragma once

#include <string>

#include "sim/core/monitor.h"
#include "sim/mesh/tet_mesh.h"
#include "sim/meshing/surface.h"

namespace griffith {

/// Fills the points of winding number at least one half by isosurface stuffing. Holes, self-intersections and loose
/// triangles do not matter. `element_size`: longer edge of the lattice [m]; thinner parts are lost. Returns an empty
/// soup if the surface has no interior. Throws InputError, about `name`, if the lattice would be too fine, and
/// Cancelled.
TetSoup stuff_surface(const TriangleSurface& surface, double element_size, double grading, const std::string& name,
                      const Monitor& monitor = {});

}  // namespace griffith
