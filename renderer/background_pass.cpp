#include "renderer/background_pass.h"

#include "renderer/shaders.h"

namespace griffith::render {

BackgroundPass::BackgroundPass() : program_("background", shaders::background_vert, shaders::background_frag) {}

void BackgroundPass::draw(const Background& background) const {
  program_.use();
  program_.set("top", background.top);
  program_.set("bottom", background.bottom);
  glBindVertexArray(vertices_.id());
  glDisable(GL_DEPTH_TEST);  // neither tested nor written
  glColorMaski(1, GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE);
  glDrawArrays(GL_TRIANGLES, 0, 3);
  glColorMaski(1, GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
  glEnable(GL_DEPTH_TEST);
}

}  // namespace griffith::render
