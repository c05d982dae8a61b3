#pragma once

#include "renderer/embedded_surface.h"
#include "renderer/shader_program.h"
#include "renderer/stream_buffer.h"

namespace griffith::render {

/// Materials on the device, for shaders that include matter.glsl.
class MaterialTable {
 public:
  void upload(const std::vector<EmbeddedMaterial>& materials);
  void bind() const { values_.bind(kMaterialsUnit); }

 private:
  StreamTexture values_{GL_R32F};
};

}  // namespace griffith::render
