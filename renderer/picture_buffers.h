#pragma once

#include <memory>

#include "renderer/blend_target.h"
#include "renderer/glass_target.h"
#include "renderer/occlusion_map.h"
#include "renderer/renderer.h"
#include "renderer/target.h"

namespace griffith::render {

/// Target of a picture, with what its effects need in its size.
struct PictureBuffers {
  Target target{1, 1};
  int requested_samples = 1;                ///< target.samples() may be fewer
  std::unique_ptr<OcclusionMap> occlusion;  ///< null until there is occlusion
  std::unique_ptr<BlendTarget> blend;       ///< for the target; null until something is transparent
  std::unique_ptr<GlassTarget> glass;       ///< for the target; null until a material is transparent

  void resize(const RenderOptions& options) {
    const bool fits = target.width() == options.width && target.height() == options.height;
    if (fits && requested_samples == options.samples) return;
    blend.reset();
    glass.reset();
    target = Target(options.width, options.height, options.samples);
    requested_samples = options.samples;
  }
};

}  // namespace griffith::render
