#pragma once

#include "sim/core/linear_algebra.h"

namespace griffith {

/// The half-space normal · x <= offset.
struct HalfSpace {
  Vec3 normal = Vec3::UnitX();  ///< unit vector, out of the half-space
  double offset = 0;            ///< [m]

  double distance(const Vec3& point) const { return normal.dot(point) - offset; }
  HalfSpace opposite() const { return {-normal, -offset}; }
};

}  // namespace griffith
