#include "renderer/ground_pass.h"

#include "renderer/shaders.h"

namespace griffith::render {

GroundPass::GroundPass() : program_("ground", shaders::ground_vert, shaders::ground_frag) {}

void GroundPass::draw(const Ground& ground, const Eigen::Vector3f& center, float radius, bool from_below) const {
  program_.use();
  program_.set("center", center.x(), ground.height, center.z());
  program_.set("radius", radius);
  program_.set("color", ground.color);
  program_.set("grid_spacing", ground.grid_spacing);
  program_.set("opacity", from_below ? 0.25f : 1.0f);
  glBindVertexArray(vertices_.id());
  glEnable(GL_BLEND);
  glDepthMask(!from_below);
  glColorMaski(1, GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE);
  glDrawArrays(GL_TRIANGLE_STRIP, 0, 4);
  glColorMaski(1, GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
  glDepthMask(GL_TRUE);
  glDisable(GL_BLEND);
}

}  // namespace griffith::render
