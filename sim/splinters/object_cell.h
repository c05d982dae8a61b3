#pragma once

#include <string>
#include <vector>

#include "sim/meshing/surface_objects.h"
#include "sim/splinters/convex_polyhedron.h"

namespace griffith {

/// Object of a file as a convex cell.
struct ObjectCell {
  std::string name;
  std::vector<HalfSpace> planes;  ///< one plane per side
  ConvexPolyhedron polyhedron;    ///< the intersection of all planes; its faces' walls are their indices
  Eigen::AlignedBox3d box;
};

/// Returns the cell of an object. `tolerance` [m]: possible rounding of the file. Throws InputError, about the cell in
/// the file `file`, for an object that is flat, not closed or not convex.
ObjectCell object_cell(const SurfaceObject& object, double tolerance, const std::string& file);

/// Returns the intersection of two cells; empty if they only touch.
ConvexPolyhedron common_part(const ObjectCell& a, const ObjectCell& b, double tolerance);

}  // namespace griffith
