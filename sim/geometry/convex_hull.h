#pragma once

#include <span>
#include <vector>

#include "sim/core/linear_algebra.h"

namespace griffith {

/// The convex hull of a point set.
struct ConvexHull {
  std::vector<Vec3> corners;            ///< exactly as given, no interior points [m]
  std::vector<std::vector<int>> faces;  ///< convex polygons of corner indices, counter-clockwise seen from outside
  double volume = 0;                    ///< [m³]; 0 when the points lie in a plane, on a line or in one spot
  double area = 0;                      ///< [m²]; a flat hull has two sides
};

/// The hull of any number of points. Which points are corners is decided on a grid of about 1e-4 of the extent, so a
/// point may stick out by that much.
ConvexHull convex_hull(std::span<const Vec3> points);

/// The corners of the hull with every face moved inward by `distance` [m]: exact where three planes meet, a least
/// squares fit where more do. A corner that has no room to move stays.
std::vector<Vec3> shrunken_corners(const ConvexHull& hull, double distance);

}  // namespace griffith
