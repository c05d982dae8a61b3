#pragma once

#include "renderer/draw_scene.h"
#include "renderer/shader_program.h"
#include "renderer/stream_buffer.h"

namespace griffith::render {

/// Spheres, or chips of stone inscribed in them. Each is a square in which the fragment shader computes the exact
/// shape; one instanced draw call.
class SpherePass {
 public:
  enum class Shape { ball, chip };
  explicit SpherePass(Shape shape = Shape::ball);
  void upload(const std::vector<Sphere>& spheres);
  void draw_shadow() const;
  void draw(Light light) const;

 private:
  void draw_squares() const;

  LitProgram program_;
  ShaderProgram shadow_program_;
  VertexArray vertices_;
  StreamBuffer spheres_;
  GLsizei count_ = 0;
};

}  // namespace griffith::render
