#include "renderer/puff_pass.h"

#include <type_traits>

#include "renderer/shaders.h"
#include "renderer/vertex_attribute.h"

namespace griffith::render {

static_assert(std::is_standard_layout_v<Puff>, "uploaded as it is");

PuffPass::PuffPass() : program_("puff", shaders::puff_vert, shaders::puff_frag) {
  glBindVertexArray(vertices_.id());
  glBindBuffer(GL_ARRAY_BUFFER, puffs_.id());
  instance_floats(0, 3, sizeof(Puff), offsetof(Puff, center));
  instance_floats(1, 1, sizeof(Puff), offsetof(Puff, radius));
  instance_floats(2, 3, sizeof(Puff), offsetof(Puff, color));
  instance_floats(3, 1, sizeof(Puff), offsetof(Puff, opacity));
}

void PuffPass::upload(const std::vector<Puff>& puffs) {
  count_ = static_cast<GLsizei>(puffs.size());
  puffs_.upload(puffs);
}

void PuffPass::draw(Light light) const {
  if (count_ == 0) return;
  program_.in(light).use();
  glEnable(GL_BLEND);
  glDepthMask(GL_FALSE);
  glColorMaski(1, GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE);  // objects behind puffs can be picked
  glBindVertexArray(vertices_.id());
  glDrawArraysInstanced(GL_TRIANGLE_STRIP, 0, 4, count_);
  glColorMaski(1, GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
  glDepthMask(GL_TRUE);
  glDisable(GL_BLEND);
}

}  // namespace griffith::render
