#pragma once

#include <vector>

#include "sim/core/linear_algebra.h"

namespace griffith::ui {

/// How the shot that is being aimed will fly.
struct Aim {
  std::vector<Vec3> flight;  ///< from the muzzle to what it meets first, or as far as it is followed [m]
  double duration = 0;       ///< of that [s]
  bool hits = false;         ///< something is met at its end
};

}  // namespace griffith::ui
