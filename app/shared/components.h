#pragma once

#include <array>

#include "sim/core/linear_algebra.h"

namespace griffith::app {

/// A vector as three numbers, which JSON shows as an array.
inline std::array<double, 3> components(const Vec3& v) { return {v.x(), v.y(), v.z()}; }

}  // namespace griffith::app
