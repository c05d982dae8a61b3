#pragma once

#include "sim/meshing/surface.h"

namespace griffith {

/// Changes and failures of orient_surface().
struct Orientation {
  int flipped_triangles = 0, inverted_shells = 0, one_sided_shells = 0;
};

/// Flips triangles until neighbors across edges of two triangles agree, keeping the orientation of the larger area.
/// Then inverts closed shells that are inside out. A closed shell inside another is a cavity or a part and keeps its
/// orientation, unless the one around it was inside out as well.
Orientation orient_surface(TriangleSurface& surface);

/// Reverses a triangle.
void flip_triangle(TriangleSurface& surface, int triangle);

}  // namespace griffith
