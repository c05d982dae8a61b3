#pragma once

#include <vector>

#include "sim/world/output/frame.h"

namespace griffith {

/// Part of a scene body that broke while it was scaled (BodyView::broke_scaled).
struct ScaledBreak {
  int scene_body = 0;
  int pieces = 0;      ///< number of pieces that cracked while scaled, or broke off one that did
  ScaledImpact least;  ///< record with the smallest f
};

/// Returns, by scene body, only those that broke while scaled.
std::vector<ScaledBreak> scaled_breaks(const Frame& frame);

}  // namespace griffith
