#pragma once

#include <algorithm>
#include <array>

#include "sim/core/linear_algebra.h"

namespace griffith {

/// Corners of a triangle in a canonical order, independent of first corner and orientation.
using FaceKey = std::array<std::array<double, 3>, 3>;

inline FaceKey face_key(const std::array<Vec3, 3>& corners) {
  FaceKey key;
  for (int i = 0; i < 3; ++i) key[i] = {corners[i].x(), corners[i].y(), corners[i].z()};
  std::ranges::sort(key);
  return key;
}

}  // namespace griffith
