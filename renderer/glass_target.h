#pragma once

#include <array>

#include "renderer/shader_program.h"
#include "renderer/target.h"

namespace griffith::render {

/// Clear matter in any order: optical depths, reflected light and slopes of its faces are added up here, before what is
/// opaque in a Target, and then decide how that is seen. Sums need no sorting, and optical depths of entered and left
/// faces, with opposite signs, give the thickness of a body exactly, or how much of it lies before what is opaque.
/// Shaders write through emit_glass() (glass.glsl).
class GlassTarget {
 public:
  /// Of the size, samples and depth of `target`, which must outlive it.
  explicit GlassTarget(const Target& target);

  /// Clears it and makes it what is drawn into, hidden faces too: they know how far what is opaque is in the target
  /// now. `world_from_clip`: inverse of the picture's projection.
  void begin(const Mat4& world_from_clip) const;
  /// Ends adding up.
  void end() const;
  /// Puts clear matter before the target's resolved picture. Leaves the target's resolved framebuffer bound.
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
  std::array<Renderbuffer, kSums> samples_;  ///< used with more than 1 sample only
  Framebuffer resolved_, multisampled_, depth_buffer_, distance_buffer_;
};

}  // namespace griffith::render
