#pragma once

#include "renderer/color_tables.h"
#include "renderer/draw_scene.h"
#include "renderer/renderer.h"
#include "renderer/shader_program.h"
#include "renderer/stream_buffer.h"

namespace griffith::render {

/// Triangles in one draw call: corners are vertices, all other data is fetched by the triangle's index.
class SurfacePass {
 public:
  SurfacePass();
  void upload(const Surface& surface);
  /// `skips_clear`: leaves transparent triangles out.
  void draw_depth(DrawnPart part) const;
  void draw(const Surface& surface, const ColorTables& color_tables, const RenderOptions& options, Output output,
            DrawnPart part) const;

 private:
  const ShaderProgram& program_for(const Surface& surface, const RenderOptions& options, Output output,
                                   DrawnPart part) const;
  void draw_triangles() const;

  LitProgram program_, transparent_program_;
  ShaderProgram plain_program_, glass_program_, grain_program_, depth_program_, part_depth_program_;
  VertexArray vertices_;
  StreamBuffer positions_, rests_;
  StreamTexture scalars_{GL_R32F}, colors_{GL_R32F}, ids_{GL_R32I}, flags_{GL_R8UI}, matters_{GL_R32I};
  GLsizei corners_ = 0;
  bool has_flags_ = false, has_matters_ = false;
};

}  // namespace griffith::render
