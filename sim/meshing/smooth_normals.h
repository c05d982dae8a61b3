#pragma once

#include <array>
#include <vector>

#include "sim/meshing/surface.h"

namespace griffith {

/// Returns unit normals per triangle and corner: those of the file if it has any. Otherwise the mean, weighted by
/// angle, over the triangles at the point that meet this one at less than `crease` [radians]. Zero if there is none.
std::vector<std::array<Vec3, 3>> smooth_normals(const TriangleSurface& surface, double crease = 0.7);

}  // namespace griffith
