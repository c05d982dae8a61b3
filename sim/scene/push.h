#pragma once

#include "sim/core/linear_algebra.h"

namespace griffith {

/// Impulse on a point of material, as a click of the mouse gives it.
struct Push {
  int tet = 0;                          ///< index of the tet with the point
  Vec3 weights = Vec3::Constant(0.25);  ///< barycentric weights of its corners 1 to 3; corner 0 has the rest to 1
  Vec3 impulse = Vec3::Zero();          ///< [N·s]
  bool operator==(const Push&) const = default;
};

}  // namespace griffith
