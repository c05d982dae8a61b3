#include "renderer/stroke_pass.h"

#include <type_traits>

#include "renderer/shaders.h"
#include "renderer/vertex_attribute.h"

namespace griffith::render {

StrokePass::StrokePass() : program_("stroke", shaders::stroke_vert, shaders::stroke_frag) {
  static_assert(std::is_standard_layout_v<Stroke>, "uploaded as it is");
  glBindVertexArray(vertices_.id());
  glBindBuffer(GL_ARRAY_BUFFER, buffer_.id());
  instance_floats(0, 3, sizeof(Stroke), offsetof(Stroke, start));
  instance_floats(1, 3, sizeof(Stroke), offsetof(Stroke, end));
  instance_floats(2, 3, sizeof(Stroke), offsetof(Stroke, color));
  instance_floats(3, 1, sizeof(Stroke), offsetof(Stroke, width));
  instance_integer(4, sizeof(Stroke), offsetof(Stroke, id));
}

void StrokePass::upload(const DrawScene& scene, float pixel_scale) {
  strokes_.clear();
  for (const Line& line : scene.lines) {
    strokes_.push_back({line.start, line.end, line.color, pixel_scale * scene.line_width, line.id});
  }
  for (const Point& point : scene.points) {
    strokes_.push_back({point.position, point.position, point.color, pixel_scale * point.diameter, point.id});
  }
  buffer_.upload(strokes_);
}

void StrokePass::draw() const {
  program_.use();
  glBindVertexArray(vertices_.id());
  glEnablei(GL_BLEND, 0);  // some drivers write wrong ids with blending
  glDrawArraysInstanced(GL_TRIANGLE_STRIP, 0, 4, static_cast<GLsizei>(strokes_.size()));
  glDisablei(GL_BLEND, 0);
}

}  // namespace griffith::render
