#pragma once

#include "renderer/color_tables.h"
#include "renderer/draw_scene.h"
#include "renderer/renderer.h"
#include "renderer/shader_program.h"
#include "renderer/stream_buffer.h"

namespace griffith::render {

/// The triangles, in one draw call: corners are vertices, everything per triangle is fetched by the triangle's number.
class SurfacePass {
 public:
  SurfacePass();
  void upload(const Surface& surface);
  void draw_shadow() const;
  void draw(const Surface& surface, const ColorTables& color_tables, const RenderOptions& options, Output output,
            DrawnPart part) const;

 private:
  void draw_triangles() const;

  ShaderProgram program_, transparent_program_, shadow_program_;
  VertexArray vertices_;
  StreamBuffer positions_;
  StreamTexture scalars_{GL_R32F}, colors_{GL_R32F}, ids_{GL_R32I}, flags_{GL_R8UI};
  GLsizei corners_ = 0;
};

}  // namespace griffith::render
