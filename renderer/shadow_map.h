#pragma once

#include <Eigen/Core>

#include "renderer/gl_objects.h"
#include "renderer/view.h"

namespace griffith::render {

/// A ball around the relevant part of the picture, which casts and receives shadows.
struct Focus {
  Eigen::Vector3f center = Eigen::Vector3f::Zero();  ///< [m]
  float radius = 1;                                  ///< [m]
};

/// Depth of a Focus in parallel projection along the light.
class ShadowMap {
 public:
  static constexpr int kMostTexels = 2048;

  ShadowMap();

  /// Clears the map with that many texels per side and binds it for drawing. If nothing is drawn, everything is lit.
  void begin(int texels);

  /// Binds the map for shaders.
  void bind() const;
  /// Binds it as the map of transparent materials, which absorb only a part of the light.
  void bind_clear() const;

  /// Returns the view to draw the map with; its shadow_matrix and light serve the picture's own view.
  static ViewBlock view(const Focus& focus, int texels);

 private:
  void resize(int texels);

  int texels_ = 0;  ///< number per side
  Texture depth_;
  Sampler depth_values_;  ///< for depths without comparison
  Framebuffer framebuffer_;
};

}  // namespace griffith::render
