#pragma once

#include <optional>

namespace griffith {

/// Method of filling a surface with tetrahedra. `tetgen`: Delaunay refinement that keeps the surface's triangles; needs
/// a sound surface. `volumetric`: a lattice fitted to the surface; accepts any surface with an interior, with elements
/// of any size. `automatic`: TetGen, or the lattice if TetGen fails.
enum class MeshingMethod { automatic, tetgen, volumetric };

/// Properties of the requested mesh.
struct MeshingOptions {
  MeshingMethod method = MeshingMethod::automatic;
  std::optional<double> element_size;  ///< target edge [m]; none: a twentieth of the bounding box's diagonal
  double grading = 1;  ///< largest ratio of inner edges to surface edges, 1..100; powers of two for the lattice
  double radius_edge_ratio = 1.4;  ///< TetGen: largest circumradius over shortest edge, >= 1.1
  double min_dihedral_angle = 10;  ///< TetGen: smallest dihedral angle it aims at [degrees], 0 .. 18
  bool operator==(const MeshingOptions&) const = default;
};

}  // namespace griffith
