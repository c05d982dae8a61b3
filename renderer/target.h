#pragma once

#include <cstdint>

#include "renderer/color.h"
#include "renderer/gl_objects.h"
#include "renderer/image.h"

namespace griffith::render {

/// Target of drawing: RGBA8 color (sRGB-encoded by the shaders), 32-bit integer ids (attachment 1) and depth, with 1 or
/// more samples. Needs a current context. Also used for the user interface: bind(), clear(), draw, resolve(), image().
/// Only bind() changes the bound framebuffer.
class Target {
 public:
  /// `samples` is limited to the maximum of the device.
  Target(int width, int height, int samples = 1);

  int width() const { return width_; }
  int height() const { return height_; }
  int samples() const { return samples_; }

  /// Binds the framebuffer for drawing, with a viewport of its size and both attachments enabled.
  void bind() const;

  /// Clears color, ids (to kNoId) and depth of the target, which must be bound.
  void clear(const Rgb& color) const;

  /// Averages the color samples and takes one sample's id. Does nothing with 1 sample.
  void resolve() const;

  /// Returns the resolved color: a GL_TEXTURE_2D whose first row is the bottom one (ImGui::Image: uv0 = (0, 1), uv1 =
  /// (1, 0)).
  unsigned color_texture() const { return color_.id(); }

  /// Returns the framebuffer of the resolved picture, for drawing over it.
  unsigned resolved_framebuffer() const { return resolved_.id(); }
  /// Returns the depth buffer, with as many samples as the target.
  unsigned depth_buffer() const { return depth_.id(); }

  Image image() const;
  IdImage ids() const;

  /// Returns the id at a pixel, counted from the top left; kNoId for none or outside.
  std::int32_t id_at(int x, int y) const;

 private:
  int width_, height_, samples_;
  Texture color_, ids_;
  Renderbuffer depth_, sample_color_, sample_ids_;  ///< sample_*: only with more than 1 sample
  Framebuffer resolved_, multisampled_;
};

}  // namespace griffith::render
