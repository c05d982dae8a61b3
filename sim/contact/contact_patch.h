#pragma once

#include <span>
#include <vector>

#include "sim/core/linear_algebra.h"

namespace griffith {

struct PatchPoint {
  Vec3 on_b;        ///< [m]
  double distance;  ///< along the normal, negative when overlapping [m]
};

/// Where two convex bodies meet, when more than a point of them does: the corners of the area (or line) common to the
/// features of `a` and `b` that face each other along `normal` (unit, from b to a). A feature is made of the corners
/// within `tolerance` [m] of the foremost one. Empty when a single corner or two crossing edges meet.
std::vector<PatchPoint> contact_patch(std::span<const Vec3> a, std::span<const Vec3> b, const Vec3& normal,
                                      double tolerance);

}  // namespace griffith
