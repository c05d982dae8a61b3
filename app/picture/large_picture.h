#pragma once

#include <functional>

#include "renderer/renderer.h"

namespace griffith::app {

/// Picture with the ids of its objects.
struct PaintedPicture {
  render::Image image;
  render::IdImage ids;
};

/// Largest side of what is drawn at once [pixels]; drivers may allow no more than 16384, and memory less.
inline constexpr int kLargestPart = 4096;

/// Draws a picture of any size: at once, or in parts that `paint` draws, if a side is longer than `largest_part`
/// [pixels]. Parts overlap, so that effects which depend on neighboring pixels have no seams.
PaintedPicture paint_in_parts(const render::RenderOptions& whole, int largest_part,
                              const std::function<PaintedPicture(const render::RenderOptions&)>& paint);

/// Draws a scene in this way.
render::Image large_picture(render::Renderer& renderer, const render::DrawScene& scene, const render::Camera& camera,
                            const render::RenderOptions& options);

}  // namespace griffith::app
