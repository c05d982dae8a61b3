#pragma once

#include "renderer/draw_scene.h"
#include "renderer/shader_program.h"

namespace griffith::render {

/// Gradient of the background; covers the whole target and leaves depth and ids unchanged.
class BackgroundPass {
 public:
  BackgroundPass();
  void draw(const Background& background) const;

 private:
  ShaderProgram program_;
  VertexArray vertices_;
};

}  // namespace griffith::render
