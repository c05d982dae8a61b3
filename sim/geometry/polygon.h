#pragma once

#include <array>
#include <span>
#include <vector>

#include "sim/core/linear_algebra.h"

namespace griffith {

/// Divides a nearly plane polygon, convex or not, into triangles by ear clipping (Meisters 1975). Returns indices into
/// `corners`: two triangles fewer than corners, with the orientation of the polygon. Empty for fewer than three
/// corners.
std::vector<std::array<int, 3>> triangulate(std::span<const Vec3> corners);

}  // namespace griffith
