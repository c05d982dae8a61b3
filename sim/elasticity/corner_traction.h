#pragma once

#include "sim/core/lanes.h"
#include "sim/elasticity/element.h"

namespace griffith {

/// B sigma g_i of a corner [Pa/m], of which the force on it is −V times, in the first three lanes; the fourth counts
/// for nothing.
inline simd::WideQuad corner_traction(const RestElement& rest, const ElementState& state, int corner) {
  const auto gradient = rest.shape_gradients.col(corner);
  const auto& [xx, yy, zz, xy, xz, yz] = state.stress;
  const double x = gradient[0], y = gradient[1], z = gradient[2];
  return simd::product(state.frame.data(), xx * x + xy * y + xz * z, xy * x + yy * y + yz * z,
                       xz * x + yz * y + zz * z);
}

}  // namespace griffith
