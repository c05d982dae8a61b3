#pragma once

#include <string>
#include <vector>

#include "sim/meshing/surface_objects.h"
#include "sim/splinters/convex_polyhedron.h"

namespace griffith {

/// An object of a file as a convex cell.
struct ObjectCell {
  std::string name;
  std::vector<HalfSpace> planes;  ///< one a side
  ConvexPolyhedron polyhedron;    ///< what is within all of them; its faces' walls are their numbers
  Eigen::AlignedBox3d box;
};

/// The cell that an object is. `tolerance` [m]: what the file's rounding may amount to. Throws InputError, about the
/// cell in the file `file`, for an object that is flat, not closed or not convex.
ObjectCell object_cell(const SurfaceObject& object, double tolerance, const std::string& file);

/// What two cells have in common; empty when they only touch.
ConvexPolyhedron common_part(const ObjectCell& a, const ObjectCell& b, double tolerance);

}  // namespace griffith
