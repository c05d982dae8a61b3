#pragma once

#include "renderer/draw_scene.h"
#include "renderer/shader_program.h"

namespace griffith::render {

/// The lines of the ground's grid: powers of ten apart, fit for how much of it is seen. The finest fade as the view
/// widens, so that no spacing comes or goes at once.
struct GridLevel {
  float spacing = 1;  ///< between the finest lines [m]
  float fade = 0;     ///< how far they have faded: 0 in full, towards 1 gone; the next are then what they were
};

/// `view_height`: of the part of the plane through the camera's target that the picture shows [m], > 0.
GridLevel grid_level(float view_height);

/// The ground plane around `center`, fading into what is behind it towards `radius` [m]. Drawn after what is
/// opaque. From below it is a veil that hides nothing.
class GroundPass {
 public:
  GroundPass();
  void draw(const Ground& ground, const GridLevel& grid, const Eigen::Vector3f& center, float radius, bool from_below,
            Light light) const;

 private:
  LitProgram program_;
  VertexArray vertices_;
};

}  // namespace griffith::render
