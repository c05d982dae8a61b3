#pragma once

#include <span>

#include "renderer/color_tables.h"
#include "renderer/draw_scene.h"
#include "renderer/renderer.h"
#include "renderer/shader_program.h"
#include "renderer/stream_buffer.h"

namespace griffith::render {

/// Polygons carried by tets. The vertex shader computes their positions, so that a frame uploads points, tets and the
/// carrier of each part, but no polygons.
class EmbeddedPass {
 public:
  EmbeddedPass();
  void upload(const EmbeddedSurface& surface);
  /// `skips_clear`: leaves transparent polygons out.
  void draw_depth(DrawnPart part) const;
  void draw(const EmbeddedSurface& surface, const ScalarStyle& style, const ColorTables& color_tables,
            const RenderOptions& options, float opacity, Output output, DrawnPart part) const;

 private:
  void upload_mesh();
  void append_triangles(std::span<const std::int32_t> polygons);
  void upload_opened(const std::vector<std::int32_t>& opened);
  const ShaderProgram& program_for(const EmbeddedSurface& surface, const RenderOptions& options, Output output,
                                   DrawnPart part) const;
  void draw_triangles(GLsizei first, GLsizei end) const;  ///< draws a range of the indices

  LitProgram program_, transparent_program_;
  ShaderProgram plain_program_, glass_program_, grain_program_, depth_program_;
  VertexArray vertices_;
  Buffer corners_, triangles_;
  StreamTexture points_{GL_R32F}, tets_{GL_R32I}, carriers_{GL_R32I}, scalars_{GL_R32F}, colors_{GL_R32F};
  std::shared_ptr<const EmbeddedMesh> mesh_;  ///< on the device
  std::vector<std::int32_t> opened_;          ///< on the device
  GLsizei indices_ = 0, outer_indices_ = 0;   ///< on the device: all, and those of the outer polygons, which come first
};

}  // namespace griffith::render
