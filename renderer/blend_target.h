#pragma once

#include "renderer/shader_program.h"
#include "renderer/target.h"

namespace griffith::render {

/// Weighted-blended transparency in any order (McGuire & Bavoil 2013): transparent things are added up here, behind
/// what is opaque in a Target, and then blended over its picture in one go. Shaders write through emit() (output.glsl).
class BlendTarget {
 public:
  /// Of the size, samples and depth of `target`, which must outlive it.
  explicit BlendTarget(const Target& target);

  /// Clears it and makes it what is drawn into; depth is tested, not written.
  void begin() const;
  /// Blends what was drawn over the target's resolved picture. Leaves the target's resolved framebuffer bound.
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
