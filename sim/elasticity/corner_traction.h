#pragma once

#include "sim/core/lanes.h"
#include "sim/elasticity/element.h"

namespace griffith {

/// B sigma g_i of a corner [Pa/m], of which the force on it is −V times, in the first three lanes; the fourth counts
/// for nothing.
inline simd::WideQuad corner_traction(const RestElement& rest, const ElementState& state, int corner) {
  const auto gradient = rest.shape_gradients.col(corner);
  const simd::WideQuad stress = simd::product(state.stress.data(), gradient[0], gradient[1], gradient[2]);
  return simd::product(state.frame.data(), stress[0], stress[1], stress[2]);
}

}  // namespace griffith
