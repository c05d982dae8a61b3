#pragma once

#include "renderer/draw_scene.h"
#include "renderer/shader_program.h"

namespace griffith::render {

/// Background; covers the whole target and leaves depth and ids unchanged.
class BackgroundPass {
 public:
  BackgroundPass();
  /// `world_from_clip`: inverse of the picture's projection.
  void draw(const Background& background, const Mat4& world_from_clip, Light light) const;

 private:
  LitProgram program_;
  VertexArray vertices_;
};

/// Spacing of the ground's grid: powers of ten that suit the view. The finest lines fade as the view widens, so that no
/// spacing appears or disappears abruptly.
struct GridLevel {
  float spacing = 1;  ///< between the finest lines [m]
  float fade = 0;     ///< fade of the finest lines, from 0 (visible) to 1 (gone); at 1 the next ones take their place
};

/// Returns the grid for a view. `view_height`: height of the view at the camera's target [m], > 0.
GridLevel grid_level(float view_height);

/// Ground plane around `center`, fading into the background toward `radius` [m]. Drawn after opaque objects. From below
/// it is a veil that hides nothing.
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
