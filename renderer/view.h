#pragma once

#include <Eigen/Core>

#include "renderer/camera.h"
#include "renderer/gl_objects.h"

namespace griffith::render {

inline constexpr GLuint kViewBinding = 0;

using Vec4 = Eigen::Matrix<float, 4, 1, Eigen::DontAlign>;

/// State of the picture for all shaders: the uniform block `View` of shaders/common.glsl, std140.
struct ViewBlock {
  Mat4 view_projection = Mat4::Identity();
  Mat4 shadow_matrix = Mat4::Identity();
  Vec4 eye = Vec4::UnitW();
  Vec4 light = Vec4::UnitY();
  Vec4 viewport = Vec4::Zero();
  Vec4 visible = Vec4::UnitW();
  Vec4 effects = Vec4::Zero();
  Vec4 surroundings = Vec4::UnitW();
};
static_assert(sizeof(ViewBlock) == (2 * 16 + 6 * 4) * sizeof(float));

/// A ViewBlock on the device.
class ViewBuffer {
 public:
  /// Uploads the block and binds it for programs.
  void bind(const ViewBlock& block) const;

 private:
  Buffer buffer_;
};

}  // namespace griffith::render
