#pragma once

#include <array>
#include <span>
#include <vector>

#include "sim/core/linear_algebra.h"

namespace griffith {

/// Cuts a polygon, convex or not and nearly plane, into triangles by clipping ears (Meisters 1975): always two fewer
/// than it has corners, turning the way it does. Indices into `corners`; nothing for fewer than three.
std::vector<std::array<int, 3>> triangulate(std::span<const Vec3> corners);

}  // namespace griffith
