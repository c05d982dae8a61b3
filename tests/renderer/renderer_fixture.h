#pragma once

#include <epoxy/gl.h>
#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <memory>
#include <vector>

#include "renderer/egl_context.h"
#include "renderer/renderer.h"

namespace griffith::render {

/// One context and one renderer for all tests of a suite: compiling the shaders takes longest.
class RendererFixture : public testing::Test {
 protected:
  static constexpr int kWidth = 320, kHeight = 200;

  static void SetUpTestSuite() {
    context_ = std::make_unique<EglContext>();
    renderer_ = std::make_unique<Renderer>();
  }
  static void TearDownTestSuite() {
    renderer_.reset();
    context_.reset();
  }

  static RenderOptions options(int samples = RenderOptions().samples) {
    RenderOptions small;
    small.width = kWidth;
    small.height = kHeight;
    small.samples = samples;
    return small;
  }

  static Image picture(const DrawScene& scene, const RenderOptions& how) {
    renderer_->render(scene, camera(), how);
    EXPECT_EQ(glGetError(), static_cast<GLenum>(GL_NO_ERROR));
    return renderer_->image();
  }

  static Camera camera() { return {{-2.6f, 2.6f, 5.2f}, {0, 1.2f, 0}, 40}; }

  static inline std::unique_ptr<EglContext> context_;
  static inline std::unique_ptr<Renderer> renderer_;
};

/// The fraction of pixels in which a channel of two images of one size differs by more than 4/255.
inline double off_fraction(const Image& a, const Image& b) {
  EXPECT_EQ(a.rgba.size(), b.rgba.size());
  int off = 0;
  for (int y = 0; y < a.height; ++y)
    for (int x = 0; x < a.width; ++x) {
      const auto one = a.pixel(x, y), other = b.pixel(x, y);
      bool differs = false;
      for (std::size_t i = 0; i < one.size(); ++i) differs |= std::abs(one[i] - other[i]) > 4;
      off += differs;
    }
  return off / (static_cast<double>(a.width) * a.height);
}

/// Light that the film shows as a byte: the inverse of displayed() in shaders/common.glsl.
inline double light_shown_as(int byte) {
  const double value = byte / 255.0;
  const double y = value <= 0.04045 ? value / 12.92 : std::pow((value + 0.055) / 1.055, 2.4);
  const double a = 2.51 - 2.43 * y, b = 0.03 - 0.59 * y;
  return (std::sqrt(b * b + 0.56 * y * a) - b) / (2 * a);
}

/// Triangles of a square across the line of sight that fills the picture, `nearer` meters before the camera's target.
inline std::vector<Eigen::Vector3f> filling_square(const Camera& camera, float nearer = 0) {
  const Eigen::Vector3f forward = (camera.target - camera.position).normalized();
  const Eigen::Vector3f right = forward.cross(Eigen::Vector3f::UnitY()).normalized(), up = right.cross(forward);
  const auto corner = [&](float x, float y) -> Eigen::Vector3f {
    return camera.target - nearer * forward + 20 * (x * right + y * up);
  };
  return {corner(-1, -1), corner(1, -1), corner(1, 1), corner(-1, -1), corner(1, 1), corner(-1, 1)};
}

}  // namespace griffith::render
