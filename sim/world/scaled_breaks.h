#pragma once

#include <vector>

#include "sim/world/frame.h"

namespace griffith {

/// What of a scene body broke while it was scaled (BodyView::broke_scaled).
struct ScaledBreak {
  int scene_body = 0;
  int pieces = 0;      ///< that cracked so, or broke off what did
  ScaledImpact least;  ///< of the smallest f
};

/// By scene body, those that broke so alone.
std::vector<ScaledBreak> scaled_breaks(const Frame& frame);

}  // namespace griffith
