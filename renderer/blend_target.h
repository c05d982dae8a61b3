#pragma once

#include "renderer/shader_program.h"
#include "renderer/target.h"

namespace griffith::render {

/// Weighted-blended order-independent transparency (McGuire & Bavoil 2013): transparent objects are accumulated here,
/// behind the opaque ones in a Target, and then blended over its picture at once. Shaders write through emit()
/// (output.glsl).
class BlendTarget {
 public:
  /// Has the size, samples and depth of `target`, which must outlive it.
  explicit BlendTarget(const Target& target);

  /// Clears and binds it for drawing; depth is tested, not written.
  void begin() const;
  /// Blends the accumulated objects over the target's resolved picture. Leaves the target's resolved framebuffer bound.
  void end() const;

 private:
  void make_buffers();

  const Target& target_;
  ShaderProgram program_;
  VertexArray vertices_;
  Texture color_sums_, weight_sums_;
  Renderbuffer sample_color_sums_, sample_weight_sums_;  ///< only with more than 1 sample
  Framebuffer resolved_, multisampled_;
};

}  // namespace griffith::render
