#pragma once

#include "renderer/draw_scene.h"
#include "renderer/shader_program.h"

namespace griffith::render {

/// The gradient behind everything; draws over the whole target, depth and ids untouched.
class BackgroundPass {
 public:
  BackgroundPass();
  void draw(const Background& background) const;

 private:
  ShaderProgram program_;
  VertexArray vertices_;
};

}  // namespace griffith::render
