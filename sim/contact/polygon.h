#pragma once

#include <array>

#include "sim/core/linear_algebra.h"

namespace griffith::contact {

/// Corners of a convex polygon, in order; at most kMaxCorners.
struct Polygon {
  static constexpr int kMaxCorners = 64;
  std::array<Vec3, kMaxCorners> corners;
  int count = 0;
  void add(const Vec3& corner) {
    if (count < kMaxCorners) corners[count++] = corner;
  }
};

/// Clips a polygon to the prism over a face along the unit vector `outward`: its normal, or one that it faces
/// (Sutherland and Hodgman 1974).
void clip(Polygon& polygon, const Polygon& face, const Vec3& outward);

}  // namespace griffith::contact
