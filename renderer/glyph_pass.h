#pragma once

#include "renderer/draw_scene.h"
#include "renderer/glyph_shapes.h"
#include "renderer/shader_program.h"
#include "renderer/stream_buffer.h"

namespace griffith::render {

/// Glyphs: a fixed mesh for each shape, one instanced draw call for opaque ones and one for the others. They cast no
/// shadow.
class GlyphPass {
 public:
  GlyphPass();
  void upload(const Glyphs& glyphs);
  void draw(Output output) const;
  bool has_transparent() const;

 private:
  /// All glyphs of one shape.
  class Batch {
   public:
    explicit Batch(const std::vector<GlyphCorner>& corners);
    void upload(const std::vector<Glyph>& glyphs);
    void draw(Output output) const;
    bool has_transparent() const { return !transparent_.glyphs.empty(); }

   private:
    struct Instances {
      VertexArray vertices;
      StreamBuffer buffer;
      std::vector<Glyph> glyphs;
    };
    void describe(const Instances& instances) const;

    Buffer corners_;
    GLsizei corner_count_;
    Instances opaque_, transparent_;
  };

  ShaderProgram program_, transparent_program_;
  Batch arrows_, balls_, discs_, boxes_;
};

}  // namespace griffith::render
