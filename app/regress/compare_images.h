#pragma once

#include <string>

#include "app/regress/pixel_mask.h"
#include "renderer/image.h"

namespace griffith::app {

/// How far a picture may be from its golden one; docs/regression.md has what the numbers were taken from. What the
/// largest difference is never matters: the noise of drivers flips single pixels at edges from one colour to another.
struct ImageTolerance {
  int channel = 4;  ///< a pixel is off where a channel differs by more [1/255]
  OffLimits off;
  // What lies below: the mean signed difference of the pixels that are not off, in any channel [1/255]. Rounding
  // cancels in it; a change of light, material or colour does not, however small.
  double drift = 0.03;       ///< of the picture
  double tile_drift = 0.25;  ///< of any tile of 32×32
};

/// What two pictures differ in, and whether they may.
struct ImageComparison {
  bool passed = false;
  std::string reason;                ///< a sentence
  bool equal = false;                ///< to the byte
  std::vector<ToleranceRule> rules;  ///< what was found and what is allowed; none where the sizes differ
  // Zero where the sizes differ.
  OffPixels off;
  int largest_difference = 0;        ///< of any channel of any pixel [1/255]: told, no rule
  double drift = 0, tile_drift = 0;  ///< of the channel where it is largest, with its sign [1/255]
  PixelRect drift_tile;              ///< where tile_drift is
};

ImageComparison compare_images(const render::Image& golden, const render::Image& actual,
                               const ImageTolerance& tolerance = {});

/// Where two pictures of one size differ: the actual one in faint grey, pixels that are off in red with a paler ring
/// so that one alone is seen, smaller differences in orange where it is brighter and in blue where darker.
render::Image difference_image(const render::Image& golden, const render::Image& actual,
                               const ImageTolerance& tolerance = {});

}  // namespace griffith::app
