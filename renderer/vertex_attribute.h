#pragma once

#include <cstddef>

#include "renderer/gl_objects.h"

namespace griffith::render {

/// Defines attribute `index` of the bound vertex array: `size` floats at `offset` of every `stride` bytes of the bound
/// buffer, one value per instance.
inline void instance_floats(GLuint index, GLint size, std::size_t stride, std::size_t offset) {
  glEnableVertexAttribArray(index);
  glVertexAttribPointer(index, size, GL_FLOAT, GL_FALSE, static_cast<GLsizei>(stride),
                        reinterpret_cast<const void*>(offset));
  glVertexAttribDivisor(index, 1);
}

/// Defines an attribute of one integer.
inline void instance_integer(GLuint index, std::size_t stride, std::size_t offset) {
  glEnableVertexAttribArray(index);
  glVertexAttribIPointer(index, 1, GL_INT, static_cast<GLsizei>(stride), reinterpret_cast<const void*>(offset));
  glVertexAttribDivisor(index, 1);
}

}  // namespace griffith::render
