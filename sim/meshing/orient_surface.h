#pragma once

#include "sim/meshing/surface.h"

namespace griffith {

/// What orient_surface() changed, and where it could not help.
struct Orientation {
  int flipped_triangles = 0, inverted_shells = 0, one_sided_shells = 0;
};

/// Turns triangles until neighbours across edges of two triangles agree, the larger area having its way; then turns
/// closed shells that are inside out. A closed shell inside another counts as right, being a cavity or a part, unless
/// the one round it was inside out as well.
Orientation orient_surface(TriangleSurface& surface);

/// Turns one triangle round.
void flip_triangle(TriangleSurface& surface, int triangle);

}  // namespace griffith
