#pragma once

#include <optional>

#include "sim/core/linear_algebra.h"

namespace griffith {

/// Returns the parameter t > 0 at which origin + t · direction hits the triangle abc from either side (Möller &
/// Trumbore 1997) [lengths of `direction`].
std::optional<double> triangle_hit(const Vec3& origin, const Vec3& direction, const Vec3& a, const Vec3& b,
                                   const Vec3& c);

}  // namespace griffith
