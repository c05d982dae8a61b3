#pragma once

#include <cstddef>
#include <vector>

#include "renderer/gl_objects.h"

namespace griffith::render {

/// A buffer refilled every frame. Its storage grows if necessary and is otherwise orphaned, so that the driver never
/// waits for the previous frame.
class StreamBuffer {
 public:
  template <class T>
  void upload(const std::vector<T>& data) {
    upload(data.data(), data.size() * sizeof(T));
  }

  GLuint id() const { return buffer_.id(); }

 private:
  void upload(const void* data, std::size_t bytes);

  Buffer buffer_;
  std::size_t capacity_ = 0;
};

/// A StreamBuffer that shaders read as a texture of `format` (GL_R32F, GL_R32I or GL_R8UI).
class StreamTexture {
 public:
  explicit StreamTexture(GLenum format) : format_(format) {}

  /// Throws RenderError if the device cannot address that many elements.
  template <class T>
  void upload(const std::vector<T>& data, std::size_t elements_each = 1) {
    check_size(data.size() * elements_each);
    buffer_.upload(data);
  }

  void bind(int unit) const;

 private:
  static void check_size(std::size_t elements);

  GLenum format_;
  StreamBuffer buffer_;
  Texture texture_;
};

}  // namespace griffith::render
