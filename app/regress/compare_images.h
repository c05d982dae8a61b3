#pragma once

#include <string>

#include "app/regress/pixel_mask.h"
#include "renderer/image.h"

namespace griffith::app {

/// Tolerance between a picture and its golden one; docs/regression.md explains the numbers. The largest difference is
/// irrelevant: noise of drivers flips single pixels at edges.
struct ImageTolerance {
  int channel = 4;  ///< a pixel is off if a channel differs by more [1/255]
  OffLimits off;
  // Drift is the mean signed difference of the pixels that are not off, in any channel [1/255]. Rounding cancels in it;
  // a change of light, material or color does not, however small.
  double drift = 0.03;       ///< limit for the picture
  double tile_drift = 0.25;  ///< limit for any tile of 32×32
};

/// Result of the comparison of two pictures.
struct ImageComparison {
  bool passed = false;
  std::string reason;                ///< a sentence
  bool equal = false;                ///< identical bytes
  std::vector<ToleranceRule> rules;  ///< measured and allowed values; none if the sizes differ
  // Zero if the sizes differ.
  OffPixels off;
  int largest_difference = 0;        ///< maximum over channels and pixels [1/255]: information, not a rule
  double drift = 0, tile_drift = 0;  ///< signed, of the channel where it is largest [1/255]
  PixelRect drift_tile;              ///< tile with tile_drift
};

ImageComparison compare_images(const render::Image& golden, const render::Image& actual,
                               const ImageTolerance& tolerance = {});

/// Returns a picture of the differences of two pictures of one size: the actual one in faint gray; pixels that are off
/// in red with a paler ring, so that a single one is visible; smaller differences in orange if it is brighter and in
/// blue if darker.
render::Image difference_image(const render::Image& golden, const render::Image& actual,
                               const ImageTolerance& tolerance = {});

}  // namespace griffith::app
