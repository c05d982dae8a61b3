#pragma once

#include <span>
#include <vector>

#include "sim/splinters/convex_cells.h"

namespace griffith {

/// A face of a convex polyhedron that was cut out of a tet by the walls of a cell.
struct PolyhedronFace {
  std::vector<int> corners;  ///< counter-clockwise seen from outside
  int tet_face = -1;         ///< face 0..3 of the tet that it is a part of; -1: none
  int wall = -1;             ///< the first of the cell's walls that it lies in; -1: none. Both: the two coincide.
};

/// A convex polyhedron; empty where it has no faces.
struct ConvexPolyhedron {
  std::vector<Vec3> corners;  ///< some may be unused
  std::vector<PolyhedronFace> faces;

  bool empty() const { return faces.empty(); }
};

/// The tet with these corners (positively oriented) [m].
ConvexPolyhedron tet_polyhedron(const std::array<Vec3, 4>& corners);

/// Cuts off what lies outside of a half-space, the cell's wall number `wall`. Corners nearer to the plane than
/// `tolerance` [m] count as in it, whichever side of it they are cut from, so that two cells that share the plane part
/// a polyhedron without overlap or gap. What is thinner than `tolerance` vanishes.
void clip(ConvexPolyhedron& polyhedron, const HalfSpace& inside, int wall, double tolerance);

/// Volume [m³] of a polyhedron.
double volume(const ConvexPolyhedron& polyhedron);
/// The area vector of a face: its outward normal times its area [m²].
Vec3 area_vector(const ConvexPolyhedron& polyhedron, const PolyhedronFace& face);

/// The part of a convex polygon within a half-space.
std::vector<Vec3> clipped(const std::vector<Vec3>& polygon, const HalfSpace& inside);
/// Half the sum of the cross products round a polygon: its normal times its area [m²].
Vec3 area_vector(const std::vector<Vec3>& polygon);

}  // namespace griffith
