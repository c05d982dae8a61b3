#pragma once

#include <optional>

#include "sim/core/linear_algebra.h"

namespace griffith {

/// How far along origin + t · direction the triangle abc is hit from either side, t > 0 (Möller & Trumbore 1997) [in
/// lengths of `direction`].
std::optional<double> triangle_hit(const Vec3& origin, const Vec3& direction, const Vec3& a, const Vec3& b,
                                   const Vec3& c);

}  // namespace griffith
