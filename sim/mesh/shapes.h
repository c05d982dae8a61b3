#pragma once

#include "sim/mesh/box_pattern.h"
#include "sim/mesh/tet_mesh.h"

namespace griffith {

// Specimens centered on the origin, of hexahedral cells of about `element_size` [m] cut into tets by `pattern`. Tets
// are positively oriented and conform. All functions throw InputError if a length is not positive and finite, or if
// there would be more than kMaxCells cells.

/// Returns a cylinder about the z axis; a short one is a disc, as in a Brazilian test. The cross section is a square
/// core in rings: a regular polygon of 4n sides, n >= 2, with corners on the circle. `element_size`: across, along the
/// axis.
TetSoup make_cylinder(double radius, double length, const Vec2& element_size, BoxPattern pattern);

/// Returns a sphere: a cubic core in shells, with the surface nodes on the sphere.
TetSoup make_sphere(double radius, double element_size, BoxPattern pattern);

/// Returns a plate of size.x × size.y × size.z with a round hole through its center along z. Cells shrink toward the
/// hole, whose wall is a polygon with corners on the circle. `element_size`: at the plate's edge, through its
/// thickness. The wall has as many sides as the outer edge of its ring has cells. Cells at a small hole are therefore
/// small, and good shapes need thin layers too. Throws InputError if the hole reaches an edge.
TetSoup make_plate_with_hole(const Vec3& size, double hole_radius, const Vec2& element_size, BoxPattern pattern);

/// Returns a box with a slit of zero width in the plane x = 0, from the side y = −size.y/2 to the depth `notch_depth`,
/// through all of z, as in a three-point bending test. The faces of the slit have separate nodes, except for a row of
/// nodes at its tip. Throws InputError unless 0 < notch_depth < size.y.
TetSoup make_notched_beam(const Vec3& size, double notch_depth, const Vec3& element_size, BoxPattern pattern);

}  // namespace griffith
