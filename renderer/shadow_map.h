#pragma once

#include <Eigen/Core>

#include "renderer/gl_objects.h"
#include "renderer/view.h"

namespace griffith::render {

/// A ball that holds what matters in the picture: what casts and receives shadows.
struct Focus {
  Eigen::Vector3f center = Eigen::Vector3f::Zero();  ///< [m]
  float radius = 1;                                  ///< [m]
};

/// The lamp's picture of a Focus: depth by parallel projection along the light.
class ShadowMap {
 public:
  static constexpr int kMostTexels = 2048;

  ShadowMap();

  /// Clears the map, of that many texels a side, and makes it what is drawn into. With nothing drawn all is lit.
  void begin(int texels);

  /// Makes the map what shaders look up.
  void bind() const;
  /// Makes it the map of clear matter, which keeps but a part of the light.
  void bind_clear() const;

  /// The view to draw the map with; its shadow_matrix and light serve for the picture's own view.
  static ViewBlock view(const Focus& focus, int texels);

 private:
  void resize(int texels);

  int texels_ = 0;  ///< of a side
  Texture depth_;
  Sampler depth_values_;  ///< for depths as they are, not compared
  Framebuffer framebuffer_;
};

}  // namespace griffith::render
