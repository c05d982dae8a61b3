#include "renderer/stream_buffer.h"

#include <algorithm>
#include <string>

#include "renderer/error.h"

namespace griffith::render {

void StreamBuffer::upload(const void* data, std::size_t bytes) {
  constexpr std::size_t kSmallest = 256;  // never without storage, so that an empty buffer can be bound
  if (bytes > capacity_ || capacity_ == 0) capacity_ = std::max(bytes + bytes / 2, kSmallest);
  glBindBuffer(GL_ARRAY_BUFFER, buffer_.id());
  glBufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(capacity_), nullptr, GL_STREAM_DRAW);
  if (bytes > 0) glBufferSubData(GL_ARRAY_BUFFER, 0, static_cast<GLsizeiptr>(bytes), data);
}

void StreamTexture::bind(int unit) const {
  glActiveTexture(GL_TEXTURE0 + unit);
  glBindTexture(GL_TEXTURE_BUFFER, texture_.id());
  glTexBuffer(GL_TEXTURE_BUFFER, format_, buffer_.id());
}

void StreamTexture::check_size(std::size_t elements) {
  GLint limit = 0;
  glGetIntegerv(GL_MAX_TEXTURE_BUFFER_SIZE, &limit);
  if (elements > static_cast<std::size_t>(limit)) {
    throw RenderError("a surface has " + std::to_string(elements) + " values; this graphics device can address " +
                      std::to_string(limit));
  }
}

}  // namespace griffith::render
