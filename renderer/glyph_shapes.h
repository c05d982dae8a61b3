#pragma once

#include <Eigen/Core>
#include <vector>

namespace griffith::render {

/// A corner of a unit solid.
struct GlyphCorner {
  Eigen::Vector3f position, normal;
};

/// Triangles, three corners each, of the unit solids that Glyph (draw_scene.h) describes.
std::vector<GlyphCorner> arrow_shape();
std::vector<GlyphCorner> ball_shape();
std::vector<GlyphCorner> disc_shape();
std::vector<GlyphCorner> box_shape();

}  // namespace griffith::render
