#pragma once

#include <array>

#include "sim/meshing/surface.h"

namespace griffith {

/// Two triangles of a surface that pass through each other, or lie on each other, beyond what they share as neighbours.
struct SelfIntersections {
  int pairs = 0;
  bool all_known = true;                ///< false: there may be more pairs
  std::array<int, 2> first = {-1, -1};  ///< of the known pairs the one with the lowest numbers
  Vec3 place = Vec3::Zero();            ///< a point of the first pair [m]
};

/// Finds the pairs, of each triangle a hundred at most: a tangle need not be counted to the end. Triangles that merely
/// touch do not count.
SelfIntersections find_self_intersections(const TriangleSurface& surface);

}  // namespace griffith
