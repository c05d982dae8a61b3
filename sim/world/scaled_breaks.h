#pragma once

#include <vector>

#include "sim/world/frame.h"

namespace griffith {

/// Part of a scene body that broke while it was scaled (BodyView::broke_scaled).
struct ScaledBreak {
  int scene_body = 0;
  int pieces = 0;      ///< that cracked so, or broke off what did
  ScaledImpact least;  ///< record with the smallest f
};

/// By scene body, those that broke so alone.
std::vector<ScaledBreak> scaled_breaks(const Frame& frame);

}  // namespace griffith
