#pragma once

#include <array>

#include "sim/meshing/surface.h"

namespace griffith {

/// Pairs of triangles of a surface that intersect or overlap beyond their shared corners.
struct SelfIntersections {
  int pairs = 0;
  bool all_known = true;                ///< false: there may be more pairs
  std::array<int, 2> first = {-1, -1};  ///< the known pair with the lowest numbers
  Vec3 place = Vec3::Zero();            ///< a point of the first pair [m]
};

/// Finds the pairs, at most a hundred per triangle. Triangles that merely touch do not count.
SelfIntersections find_self_intersections(const TriangleSurface& surface);

}  // namespace griffith
