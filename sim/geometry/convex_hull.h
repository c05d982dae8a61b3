#pragma once

#include <span>
#include <vector>

#include "sim/core/linear_algebra.h"

namespace griffith {

/// Convex hull of a point set.
struct ConvexHull {
  std::vector<Vec3> corners;            ///< corners exactly as given, without interior points [m]
  std::vector<std::vector<int>> faces;  ///< convex polygons of corner indices, counterclockwise seen from outside
  double volume = 0;                    ///< volume [m³]; 0 if the points lie in a plane, on a line or in one spot
  double area = 0;                      ///< area [m²]; a flat hull has two sides
};

/// Returns the hull of any number of points. Corners are found on a grid of about 1e-4 of the extent, so a point may
/// stick out by that much.
ConvexHull convex_hull(std::span<const Vec3> points);

/// Returns the corners of the hull with every face moved inward by `distance` [m]: exact at corners of three faces, a
/// least-squares fit at others. A corner without room to move stays in place.
std::vector<Vec3> shrunken_corners(const ConvexHull& hull, double distance);

}  // namespace griffith
