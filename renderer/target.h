#pragma once

#include <cstdint>

#include "renderer/color.h"
#include "renderer/gl_objects.h"
#include "renderer/image.h"

namespace griffith::render {

/// What is drawn into: RGBA8 colour (sRGB-encoded by the shaders), 32-bit integer ids (attachment 1) and depth, with 1
/// or more samples. Needs a current context. Serves for the user interface too: bind(), clear(), draw,
/// resolve(), image(). Only bind() changes which framebuffer is bound.
class Target {
 public:
  /// `samples` is lowered to what the device can do.
  Target(int width, int height, int samples = 1);

  int width() const { return width_; }
  int height() const { return height_; }
  int samples() const { return samples_; }

  /// Makes it the framebuffer that is drawn into, with a viewport of its size, both attachments enabled.
  void bind() const;

  /// Clears colour, ids (to kNoId) and depth of the target, which must be bound.
  void clear(const Rgb& color) const;

  /// Averages the colour samples and takes one sample's id. Nothing happens with 1 sample.
  void resolve() const;

  /// The resolved colour: a GL_TEXTURE_2D whose first row is the bottom one (ImGui::Image: uv0 = (0, 1), uv1 = (1, 0)).
  unsigned color_texture() const { return color_.id(); }

  /// The framebuffer of the resolved picture, to draw over it.
  unsigned resolved_framebuffer() const { return resolved_.id(); }
  /// Depth, with as many samples as the target.
  unsigned depth_buffer() const { return depth_.id(); }

  Image image() const;
  IdImage ids() const;

  /// The id drawn at a pixel, counted from the top left, kNoId where nothing is or outside.
  std::int32_t id_at(int x, int y) const;

 private:
  int width_, height_, samples_;
  Texture color_, ids_;
  Renderbuffer depth_, sample_color_, sample_ids_;  ///< sample_*: only with more than 1 sample
  Framebuffer resolved_, multisampled_;
};

}  // namespace griffith::render
