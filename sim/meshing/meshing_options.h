#pragma once

#include <optional>

namespace griffith {

/// How a surface is filled with tetrahedra. `tetgen`: a Delaunay refinement that keeps the surface's triangles; it
/// needs a sound surface. `volumetric`: a lattice fitted to the surface; it takes any surface that has an inside, and
/// its elements are as large as wanted however fine the surface is. `automatic`: TetGen, and where it refuses, the
/// lattice.
enum class MeshingMethod { automatic, tetgen, volumetric };

/// What kind of mesh is wanted.
struct MeshingOptions {
  MeshingMethod method = MeshingMethod::automatic;
  std::optional<double> element_size;  ///< wanted edge of a tet [m]; none: a twentieth of the bounding box's diagonal
  double grading =
      1;  ///< how many times longer edges may be deep inside than at the surface, 1..100; powers of two for the lattice
  double radius_edge_ratio = 1.4;  ///< TetGen: most circumradius over shortest edge, >= 1.1
  double min_dihedral_angle = 10;  ///< TetGen: smallest angle between faces that it works for [degrees], 0 .. 18
  bool operator==(const MeshingOptions&) const = default;
};

}  // namespace griffith
