#pragma once

#include <cstdint>
#include <vector>

#include "sim/world/output/frame.h"

namespace griffith::c {

/// Triangles of each body in the body's own frame, in the form of graphics libraries: the outside and the crack faces
/// of its tetrahedra, or its splinters if it has them. Each triangle has vertices of its own with its normal, since
/// debris has sharp edges.
class Surfaces {
 public:
  /// Updates all bodies. Vertices that have moved by less than a hundred-thousandth of the body's size stay, so that
  /// rigid bodies are uploaded once.
  void update(const Frame& frame);

  // Arrays of all bodies, one after the other.
  std::vector<float> positions;              ///< 3 per vertex [m]
  std::vector<float> normals;                ///< 3 per vertex, unit length
  std::vector<std::int32_t> triangles;       ///< 3 vertices per triangle, relative to the body's first
  std::vector<std::uint8_t> is_crack;        ///< per triangle
  std::vector<std::int32_t> first_vertices;  ///< per body, as the following
  std::vector<std::int32_t> vertex_counts;
  std::vector<std::int32_t> first_triangles;
  std::vector<std::int32_t> triangle_counts;
  std::vector<std::int32_t> versions;  ///< number of changes of a body's vertices

 private:
  /// Triangles of one body.
  struct Piece {
    std::vector<Vec3> corners;           ///< 3 per triangle, in the body's frame [m]
    std::vector<std::uint8_t> is_crack;  ///< per triangle
    std::int32_t version = 0;
  };
  static std::vector<Piece> pieces_of(const Frame& frame);
  static bool is_same(const Piece& known, const Piece& now);
  void flatten();

  std::vector<Piece> pieces_;  ///< per body
};

}  // namespace griffith::c
