#include "renderer/glyph_pass.h"

#include <type_traits>

#include "renderer/shaders.h"
#include "renderer/vertex_attribute.h"

namespace griffith::render {

static_assert(std::is_standard_layout_v<Glyph>, "uploaded as it is");

GlyphPass::Batch::Batch(const std::vector<GlyphCorner>& corners) : corner_count_(static_cast<GLsizei>(corners.size())) {
  glBindBuffer(GL_ARRAY_BUFFER, corners_.id());
  glBufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(corners.size() * sizeof(GlyphCorner)), corners.data(),
               GL_STATIC_DRAW);
  describe(opaque_);
  describe(transparent_);
}

void GlyphPass::Batch::describe(const Instances& instances) const {
  glBindVertexArray(instances.vertices.id());
  glBindBuffer(GL_ARRAY_BUFFER, corners_.id());
  for (const GLuint index : {0u, 1u}) {
    glEnableVertexAttribArray(index);
    glVertexAttribPointer(index, 3, GL_FLOAT, GL_FALSE, sizeof(GlyphCorner),
                          reinterpret_cast<const void*>(index * sizeof(Eigen::Vector3f)));
  }
  glBindBuffer(GL_ARRAY_BUFFER, instances.buffer.id());
  instance_floats(2, 3, sizeof(Glyph), offsetof(Glyph, center));
  for (GLuint axis = 0; axis < 3; ++axis)
    instance_floats(3 + axis, 3, sizeof(Glyph), offsetof(Glyph, axes) + axis * sizeof(Eigen::Vector3f));
  instance_floats(6, 3, sizeof(Glyph), offsetof(Glyph, color));
  instance_floats(7, 1, sizeof(Glyph), offsetof(Glyph, opacity));
  instance_integer(8, sizeof(Glyph), offsetof(Glyph, id));
}

void GlyphPass::Batch::upload(const std::vector<Glyph>& glyphs) {
  opaque_.glyphs.clear();
  transparent_.glyphs.clear();
  for (const Glyph& glyph : glyphs) (glyph.opacity < 1 ? transparent_ : opaque_).glyphs.push_back(glyph);
  opaque_.buffer.upload(opaque_.glyphs);
  transparent_.buffer.upload(transparent_.glyphs);
}

void GlyphPass::Batch::draw(Output output) const {
  const Instances& instances = output == Output::opaque ? opaque_ : transparent_;
  if (instances.glyphs.empty()) return;
  glBindVertexArray(instances.vertices.id());
  glDrawArraysInstanced(GL_TRIANGLES, 0, corner_count_, static_cast<GLsizei>(instances.glyphs.size()));
}

GlyphPass::GlyphPass()
    : program_("glyph", shaders::glyph_vert, with_output(shaders::glyph_frag, Output::opaque).c_str()),
      transparent_program_("transparent glyph", shaders::glyph_vert,
                           with_output(shaders::glyph_frag, Output::transparent).c_str()),
      arrows_(arrow_shape()),
      balls_(ball_shape()),
      discs_(disc_shape()),
      boxes_(box_shape()) {}

void GlyphPass::upload(const Glyphs& glyphs) {
  arrows_.upload(glyphs.arrows);
  balls_.upload(glyphs.balls);
  discs_.upload(glyphs.discs);
  boxes_.upload(glyphs.boxes);
}

void GlyphPass::draw(Output output) const {
  (output == Output::opaque ? program_ : transparent_program_).use();
  for (const Batch* batch : {&arrows_, &balls_, &discs_, &boxes_}) batch->draw(output);
}

bool GlyphPass::has_transparent() const {
  return arrows_.has_transparent() || balls_.has_transparent() || discs_.has_transparent() || boxes_.has_transparent();
}

}  // namespace griffith::render
