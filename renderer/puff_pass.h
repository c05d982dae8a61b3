#pragma once

#include "renderer/draw_scene.h"
#include "renderer/shader_program.h"
#include "renderer/stream_buffer.h"

namespace griffith::render {

/// Puffs: soft discs facing the eye, blended over opaque objects in their order. One instanced draw call.
class PuffPass {
 public:
  PuffPass();
  void upload(const std::vector<Puff>& puffs);
  /// Leaves blending off and depth unchanged.
  void draw(Light light) const;

 private:
  LitProgram program_;
  VertexArray vertices_;
  StreamBuffer puffs_;
  GLsizei count_ = 0;
};

}  // namespace griffith::render
