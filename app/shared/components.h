#pragma once

#include <array>

#include "sim/core/linear_algebra.h"

namespace griffith::app {

/// Returns a vector as three numbers, which become a JSON array.
inline std::array<double, 3> components(const Vec3& v) { return {v.x(), v.y(), v.z()}; }

}  // namespace griffith::app
