#pragma once

#include "renderer/shader_program.h"

namespace griffith::render {

/// Ambient occlusion: how open to the sky what is seen at each pixel is, found from depth alone. The map may be
/// smaller than the picture.
class OcclusionMap {
 public:
  /// Of that size [pixels].
  OcclusionMap(int width, int height);

  int width() const { return width_; }
  int height() const { return height_; }

  /// Clears it and makes its depth what is drawn into.
  void begin() const;

  /// Finds the occlusion of what was drawn with that `view_projection`, by what is within `reach` [m], and makes it
  /// what shaders look up. The View block must be bound.
  void finish(const Mat4& view_projection, float reach, int samples) const;

 private:
  int width_, height_;
  ShaderProgram occlusion_, blur_;
  VertexArray vertices_;
  Texture depth_, raw_, blurred_;
  Framebuffer depth_buffer_, raw_buffer_, blurred_buffer_;
};

}  // namespace griffith::render
