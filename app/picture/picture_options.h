#pragma once

#include <algorithm>
#include <optional>

#include "app/picture/quantities.h"
#include "renderer/renderer.h"
#include "sim/scene/scene.h"

namespace griffith::app {

/// Pixels of what is written over a picture of this size per design pixel, which is one of 1280×720: small pictures
/// keep it legible.
inline float writing_scale(int width, int height) {
  constexpr float kDesignWidth = 1280, kDesignHeight = 720, kMinScale = 0.8f;
  return std::max(std::min(static_cast<float>(width) / kDesignWidth, static_cast<float>(height) / kDesignHeight),
                  kMinScale);
}

/// The renderer's name of a quality.
inline render::Quality picture_quality(PictureQuality quality) {
  if (quality == PictureQuality::high) return render::Quality::high;
  return quality == PictureQuality::standard ? render::Quality::standard : render::Quality::draft;
}

/// Samples a pixel that a quality has: a draft has no smoothed edges.
inline int samples_of(PictureQuality quality) { return quality == PictureQuality::draft ? 1 : 4; }

/// Whether splinters and shards are what a view shows: values belong to elements, which those have nothing to do with.
inline bool shows_shards(const ViewSettings& view) {
  return view.splinters && view.quantity != "tet" && !is_scalar(view.quantity) &&
         view.elements == ElementStyle::surface;
}

/// How to draw a picture of this size [pixels] and view, with the samples a pixel of its quality if absent: lines are
/// as thick in proportion to the picture's height, whatever its resolution, as long as they can be seen.
inline render::RenderOptions picture_options(int width, int height, std::optional<int> samples,
                                             const ViewSettings& view) {
  constexpr float kDesignHeight = 720, kMinScale = 0.6f;
  render::RenderOptions options;
  options.width = width;
  options.height = height;
  options.samples = samples.value_or(samples_of(view.quality));
  options.quality = picture_quality(view.quality);
  options.edges = view.edges && !shows_shards(view);
  options.unlit_scalars = !view.shading;
  options.edge_width = static_cast<float>(view.edge_width);
  options.pixel_scale = std::max(static_cast<float>(height) / kDesignHeight, kMinScale);
  return options;
}

}  // namespace griffith::app
