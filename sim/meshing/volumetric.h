#pragma once

#include <string>

#include "sim/core/monitor.h"
#include "sim/mesh/tet_mesh.h"
#include "sim/meshing/surface.h"

namespace griffith {

/// Fills what a surface winds round at least half (its generalised winding number) by isosurface stuffing, so that
/// holes, crossings and loose triangles do no harm. `element_size`: the longer edge of the lattice [m]; what is thinner
/// is lost. The soup is empty when the surface has no inside. Throws InputError, about `name`, when the lattice would
/// be too fine, and Cancelled.
TetSoup stuff_surface(const TriangleSurface& surface, double element_size, double grading, const std::string& name,
                      const Monitor& monitor = {});

}  // namespace griffith
