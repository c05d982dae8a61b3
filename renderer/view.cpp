#include "renderer/view.h"

namespace griffith::render {

void ViewBuffer::bind(const ViewBlock& block) const {
  glBindBuffer(GL_UNIFORM_BUFFER, buffer_.id());
  glBufferData(GL_UNIFORM_BUFFER, sizeof(ViewBlock), &block, GL_STREAM_DRAW);
  glBindBufferBase(GL_UNIFORM_BUFFER, kViewBinding, buffer_.id());
}

}  // namespace griffith::render
