#pragma once

#include <vector>

#include "sim/core/linear_algebra.h"

namespace griffith::ui {

/// Predicted flight of the shot being aimed.
struct Aim {
  std::vector<Vec3> flight;  ///< path from the muzzle to the first hit, or as far as it is followed [m]
  double duration = 0;       ///< flight time [s]
  bool hits = false;         ///< true if the path ends at a hit
};

}  // namespace griffith::ui
