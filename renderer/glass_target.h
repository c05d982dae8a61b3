#pragma once

#include <array>

#include "renderer/shader_program.h"
#include "renderer/target.h"

namespace griffith::render {

/// Transparent materials in any order. Optical depths, reflected light and slopes of their faces are accumulated here,
/// in front of the opaque part of a Target, and then determine its appearance. Sums need no sorting. Optical depths of
/// entered and left faces have opposite signs, so that their sum is exactly the thickness of a body, or its part in
/// front of opaque objects. Shaders write through emit_glass() (glass.glsl).
class GlassTarget {
 public:
  /// Has the size, samples and depth of `target`, which must outlive it.
  explicit GlassTarget(const Target& target);

  /// Clears and binds it for drawing, including hidden faces, and measures the distance to opaque objects of the
  /// target. `world_from_clip`: inverse of the picture's projection.
  void begin(const Mat4& world_from_clip) const;
  /// Ends the accumulation.
  void end() const;
  /// Blends the transparent materials over the target's resolved picture. Leaves the target's resolved framebuffer
  /// bound.
  void blend() const;

 private:
  void make_buffers();
  void make_distance_buffers();
  void measure_distances(const Mat4& world_from_clip) const;
  void resolve() const;

  static constexpr std::size_t kSums = 3;

  const Target& target_;
  ShaderProgram program_, distance_program_;
  VertexArray vertices_;
  std::array<Texture, kSums> sums_;
  Texture opaque_, depth_, distances_;
  std::array<Renderbuffer, kSums> samples_;  ///< only with more than 1 sample
  Framebuffer resolved_, multisampled_, depth_buffer_, distance_buffer_;
};

}  // namespace griffith::render
