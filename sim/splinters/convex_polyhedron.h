#pragma once

#include <span>
#include <vector>

#include "sim/splinters/convex_cells.h"

namespace griffith {

/// Face of a convex polyhedron cut out of a tet by the walls of a cell.
struct PolyhedronFace {
  std::vector<int> corners;  ///< counterclockwise seen from outside
  int tet_face = -1;         ///< the tet's face 0..3 that contains it; -1: none
  int wall = -1;             ///< first of the cell's walls that contains it; -1: none. With both set, the two coincide.
};

/// Convex polyhedron; empty if it has no faces.
struct ConvexPolyhedron {
  std::vector<Vec3> corners;  ///< some may be unused
  std::vector<PolyhedronFace> faces;

  bool empty() const { return faces.empty(); }
};

/// Returns the tet with these corners (positively oriented) [m].
ConvexPolyhedron tet_polyhedron(const std::array<Vec3, 4>& corners);

/// Removes the part outside a half-space, the cell's wall number `wall`. Corners nearer to the plane than `tolerance`
/// [m] count as on it, for cuts from either side, so that two cells that share the plane divide a polyhedron without
/// overlap or gap. Parts thinner than `tolerance` vanish.
void clip(ConvexPolyhedron& polyhedron, const HalfSpace& inside, int wall, double tolerance);

/// Returns the volume of a polyhedron [m³].
double volume(const ConvexPolyhedron& polyhedron);
/// Returns the area vector of a face: its outward normal times its area [m²].
Vec3 area_vector(const ConvexPolyhedron& polyhedron, const PolyhedronFace& face);

/// Returns the part of a convex polygon within a half-space.
std::vector<Vec3> clipped(const std::vector<Vec3>& polygon, const HalfSpace& inside);
/// Returns half the sum of the cross products around a polygon: its normal times its area [m²].
Vec3 area_vector(const std::vector<Vec3>& polygon);

}  // namespace griffith
