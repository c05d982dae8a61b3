#pragma once

#include "renderer/gl_objects.h"
#include "renderer/image.h"

namespace griffith::render {

/// An image on the graphics device for user interfaces: a GL_TEXTURE_2D whose first row is the top one, with mipmaps.
/// Needs a current context from construction to destruction.
class ImageTexture {
 public:
  explicit ImageTexture(const Image& image);

  unsigned id() const { return texture_.id(); }

 private:
  Texture texture_;
};

}  // namespace griffith::render
