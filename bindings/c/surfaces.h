#pragma once

#include <cstdint>
#include <vector>

#include "sim/world/frame.h"

namespace griffith::c {

/// Triangles of each body in the body's own frame, as graphics libraries take them: the outside and the crack faces of
/// its tetrahedra, or its splinters where it has them. Each triangle has vertices of its own with its normal, since
/// debris has sharp edges.
class Surfaces {
 public:
  /// Brings all bodies up to date. Vertices that have moved by less than a hundred-thousandth of the body's size stay,
  /// so that what is rigid is uploaded once.
  void update(const Frame& frame);

  // Of all bodies, one after the other.
  std::vector<float> positions;              ///< 3 a vertex [m]
  std::vector<float> normals;                ///< 3 a vertex, unit length
  std::vector<std::int32_t> triangles;       ///< 3 vertices a triangle, counted from the body's first
  std::vector<std::uint8_t> is_crack;        ///< per triangle
  std::vector<std::int32_t> first_vertices;  ///< per body, as the following
  std::vector<std::int32_t> vertex_counts;
  std::vector<std::int32_t> first_triangles;
  std::vector<std::int32_t> triangle_counts;
  std::vector<std::int32_t> versions;  ///< counts the changes of a body's vertices

 private:
  /// The triangles of one body.
  struct Piece {
    std::vector<Vec3> corners;           ///< 3 a triangle, in the body's frame [m]
    std::vector<std::uint8_t> is_crack;  ///< per triangle
    std::int32_t version = 0;
  };
  static std::vector<Piece> pieces_of(const Frame& frame);
  static bool is_same(const Piece& known, const Piece& now);
  void flatten();

  std::vector<Piece> pieces_;  ///< per body
};

}  // namespace griffith::c
