#pragma once

#include <string>

#include "app/regress/pixel_mask.h"
#include "renderer/image.h"

namespace griffith::app {

/// Result of the comparison of ids.
struct IdComparison {
  bool passed = false;
  std::string reason;                ///< a sentence with the ids that are gone or new
  OffPixels off;                     ///< pixels with different ids; zero if the sizes differ
  std::vector<ToleranceRule> rules;  ///< measured and allowed values; none if the sizes differ
};

/// Compares ids. Every pixel with a different id is off: ids are not blended, so noise of drivers appears at edges of
/// objects.
IdComparison compare_ids(const render::IdImage& golden, const render::IdImage& actual, const OffLimits& limits = {});

}  // namespace griffith::app
