#pragma once

#include "renderer/shader_program.h"

namespace griffith::render {

/// Ambient occlusion: the openness to the sky of the visible point at each pixel, computed from depth alone. The map
/// may be smaller than the picture.
class OcclusionMap {
 public:
  /// `width`, `height`: of the map [pixels].
  OcclusionMap(int width, int height);

  int width() const { return width_; }
  int height() const { return height_; }

  /// Clears the map and binds its depth for drawing.
  void begin() const;

  /// Computes the occlusion within `reach` [m] of the objects drawn with that `view_projection`, and binds it for
  /// shaders. The View block must be bound.
  void finish(const Mat4& view_projection, float reach, int samples) const;

 private:
  int width_, height_;
  ShaderProgram occlusion_, blur_;
  VertexArray vertices_;
  Texture depth_, raw_, blurred_;
  Framebuffer depth_buffer_, raw_buffer_, blurred_buffer_;
};

}  // namespace griffith::render
