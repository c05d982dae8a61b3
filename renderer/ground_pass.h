#pragma once

#include "renderer/draw_scene.h"
#include "renderer/shader_program.h"

namespace griffith::render {

/// The ground plane around `center`, fading into what is behind it towards `radius` [m]. Drawn after what is
/// opaque. From below it is a veil that hides nothing.
class GroundPass {
 public:
  GroundPass();
  void draw(const Ground& ground, const Eigen::Vector3f& center, float radius, bool from_below) const;

 private:
  ShaderProgram program_;
  VertexArray vertices_;
};

}  // namespace griffith::render
