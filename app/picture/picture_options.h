#pragma once

#include <algorithm>
#include <optional>

#include "app/picture/quantities.h"
#include "renderer/renderer.h"
#include "sim/scene/scene.h"

namespace griffith::app {

/// Returns the pixels per design pixel of text in a picture of this size; the design size is 1280×720. Small pictures
/// keep text legible.
inline float writing_scale(int width, int height) {
  constexpr float kDesignWidth = 1280, kDesignHeight = 720, kMinScale = 0.8f;
  return std::max(std::min(static_cast<float>(width) / kDesignWidth, static_cast<float>(height) / kDesignHeight),
                  kMinScale);
}

/// Converts a quality to that of the renderer.
inline render::Quality picture_quality(PictureQuality quality) {
  if (quality == PictureQuality::high) return render::Quality::high;
  return quality == PictureQuality::standard ? render::Quality::standard : render::Quality::draft;
}

/// Returns the samples per pixel of a quality; a draft has no antialiasing.
inline int samples_of(PictureQuality quality) { return quality == PictureQuality::draft ? 1 : 4; }

/// True if a view shows splinters and shards: it shows no values, which belong to elements.
inline bool shows_shards(const ViewSettings& view) {
  return view.splinters && view.quantity != "tet" && !is_scalar(view.quantity) &&
         view.elements == ElementStyle::surface;
}

/// Returns render options for a picture of this size [pixels] and view; `samples` per pixel default to those of its
/// quality. Line widths are proportional to the picture's height, but never invisible.
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
