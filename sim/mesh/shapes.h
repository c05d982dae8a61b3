#pragma once

#include "sim/mesh/box_pattern.h"
#include "sim/mesh/tet_mesh.h"

namespace griffith {

// Specimens centred on the origin, of hexahedral cells of about `element_size` [m], cut into tets by `pattern`:
// positively oriented, conforming. All throw InputError when a length is not positive and finite, or when they would
// take more than kMaxCells cells.

/// A cylinder about the z axis; a short one is a disc, as in a Brazilian test. The cross-section is a square core in
/// rings: a regular polygon of 4n sides, n >= 2, whose corners lie on the circle. `element_size`: across, along the
/// axis.
TetSoup make_cylinder(double radius, double length, const Vec2& element_size, BoxPattern pattern);

/// A sphere: a cube-like core in shells; the surface nodes lie on the sphere.
TetSoup make_sphere(double radius, double element_size, BoxPattern pattern);

/// A plate of size.x × size.y × size.z with a round hole through its middle along z; cells shrink towards the hole,
/// whose wall is a polygon with corners on the circle. `element_size`: at the plate's edge, through its thickness. The
/// wall has as many sides as its ring's outer edge has cells: round a small hole cells are small, and good shapes need
/// thin levels, too. Throws InputError when the hole reaches an edge.
TetSoup make_plate_with_hole(const Vec3& size, double hole_radius, const Vec2& element_size, BoxPattern pattern);

/// A box with a slit of no width in the plane x = 0, from the side y = −size.y/2 to the depth `notch_depth`, through
/// all of z, as in a three-point bending test. The slit's faces have nodes of their own, except at its tip, where there
/// is a row of nodes. Throws InputError unless 0 < notch_depth < size.y.
TetSoup make_notched_beam(const Vec3& size, double notch_depth, const Vec3& element_size, BoxPattern pattern);

}  // namespace griffith
