#include "renderer/surroundings.h"

#include <cmath>

#include "renderer/shaders.h"

namespace griffith::render {

BackgroundPass::BackgroundPass() : program_("background", shaders::background_vert, shaders::background_frag) {}

void BackgroundPass::draw(const Background& background, const Mat4& world_from_clip, Light light) const {
  const ShaderProgram& program = program_.in(light);
  program.use();
  program.set("top", background.top);
  program.set("bottom", background.bottom);
  program.set("sky_share", background.is_sky ? 1.0f : 0.0f);
  program.set("world_from_clip", world_from_clip);
  glBindVertexArray(vertices_.id());
  glDisable(GL_DEPTH_TEST);  // neither tested nor written
  glColorMaski(1, GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE);
  glDrawArrays(GL_TRIANGLES, 0, 3);
  glColorMaski(1, GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
  glEnable(GL_DEPTH_TEST);
}

GridLevel grid_level(float view_height) {
  constexpr float kCoarsest = 0.4f;  // spacing of the finest lines in heights of the view
  const float level = std::log10(kCoarsest * view_height), whole = std::floor(level);
  return {std::pow(10.0f, whole), level - whole};
}

GroundPass::GroundPass() : program_("ground", shaders::ground_vert, shaders::ground_frag) {}

void GroundPass::draw(const Ground& ground, const GridLevel& grid, const Eigen::Vector3f& center, float radius,
                      bool from_below, Light light) const {
  const ShaderProgram& program = program_.in(light);
  program.use();
  program.set("center", center.x(), ground.height, center.z());
  program.set("radius", radius);
  program.set("color", ground.color);
  program.set("grid_spacing", grid.spacing);
  program.set("grid_fade", grid.fade);
  program.set("opacity", from_below ? 0.25f : 1.0f);
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
