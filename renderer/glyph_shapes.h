#pragma once

#include <Eigen/Core>
#include <vector>

namespace griffith::render {

/// A corner of a unit solid.
struct GlyphCorner {
  Eigen::Vector3f position, normal;
};

/// Each returns the triangles of a unit solid of Glyph (draw_scene.h), three corners each.
std::vector<GlyphCorner> arrow_shape();
std::vector<GlyphCorner> ball_shape();
std::vector<GlyphCorner> disc_shape();
std::vector<GlyphCorner> box_shape();

}  // namespace griffith::render
