#pragma once

#include <array>

#include "sim/meshing/surface.h"

namespace griffith {

/// Two triangles of a surface that pass through each other, or lie on each other, beyond what they share as neighbours.
struct SelfIntersections {
  int pairs = 0;
  std::array<int, 2> first = {-1, -1};  ///< the pair with the lowest numbers
  Vec3 place = Vec3::Zero();            ///< a point of the first pair [m]
};

/// Finds all pairs. Triangles that merely touch do not count.
SelfIntersections find_self_intersections(const TriangleSurface& surface);

}  // namespace griffith
