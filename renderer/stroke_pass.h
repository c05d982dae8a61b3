#pragma once

#include "renderer/draw_scene.h"
#include "renderer/shader_program.h"
#include "renderer/stream_buffer.h"

namespace griffith::render {

/// Lines and points of fixed width on the screen, antialiased, in one instanced draw call. They cast no shadow.
class StrokePass {
 public:
  StrokePass();
  /// `pixel_scale`: factor on all widths.
  void upload(const DrawScene& scene, float pixel_scale);
  void draw() const;

 private:
  /// A line; a point is a stroke of zero length.
  struct Stroke {
    Eigen::Vector3f start, end;  // [m]
    Rgb color;
    float width;  // [pixels]
    std::int32_t id;
  };

  ShaderProgram program_;
  VertexArray vertices_;
  StreamBuffer buffer_;
  std::vector<Stroke> strokes_;
};

}  // namespace griffith::render
