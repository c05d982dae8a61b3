#pragma once

#include <string>

#include "app/regress/pixel_mask.h"
#include "renderer/image.h"

namespace griffith::app {

/// What is drawn elsewhere, and whether it may.
struct IdComparison {
  bool passed = false;
  std::string reason;                ///< a sentence; names ids that are gone or new
  OffPixels off;                     ///< pixels of another id; zero where the sizes differ
  std::vector<ToleranceRule> rules;  ///< what was found and what is allowed; none where the sizes differ
};

/// Every pixel whose id differs is off: ids are not blended, so edges of objects are where noise of drivers may be.
IdComparison compare_ids(const render::IdImage& golden, const render::IdImage& actual, const OffLimits& limits = {});

}  // namespace griffith::app
