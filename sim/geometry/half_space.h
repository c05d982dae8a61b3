#pragma once

#include "sim/core/linear_algebra.h"

namespace griffith {

/// Half-space normal · x <= offset.
struct HalfSpace {
  Vec3 normal = Vec3::UnitX();  ///< unit vector out of the half-space
  double offset = 0;            ///< distance of the plane from the origin along `normal` [m]

  double distance(const Vec3& point) const { return normal.dot(point) - offset; }
  HalfSpace opposite() const { return {-normal, -offset}; }
};

}  // namespace griffith
