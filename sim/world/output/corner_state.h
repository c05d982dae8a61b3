#pragma once

#include "sim/core/linear_algebra.h"
#include "sim/world/output/frame.h"
#include "sim/world/setup/rest_body.h"

namespace griffith {

/// Stress and energy density in an element, or their mean over some.
struct CornerState {
  Mat3 stress = Mat3::Zero();  ///< Cauchy stress, world frame [Pa]
  double energy_density = 0;   ///< [J/m³]
};

/// True if a tet is quadratic: its stress is linear then, else uniform.
bool is_quadratic(const Frame& frame, TetId tet);

/// Returns the state of a tet at one of its corners.
CornerState corner_state(const Frame& frame, const TetCorner& corner);

}  // namespace griffith
