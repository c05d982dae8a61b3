#pragma once

#include <array>
#include <string>

#include "sim/mesh/tet_mesh.h"

namespace griffith {

/// Shapes of the tets of a mesh.
struct MeshQuality {
  static constexpr int kBins = 18;

  int nodes = 0, tets = 0, surface_triangles = 0;
  double volume = 0;                          ///< [m³]
  double min_dihedral = 0, max_dihedral = 0;  ///< [degrees]
  std::array<int, kBins> dihedrals = {};      ///< six per tet, in bins of 10°
  double worst_aspect_ratio = 1, mean_aspect_ratio = 1;
  std::array<int, kBins> aspect_ratios = {};  ///< bins of 1 .. 1.5, 1.5 .. 2 and so on, the last one open
  double shortest_edge = 0, mean_edge = 0, longest_edge = 0;  ///< [m]
};

/// Returns the dihedral angles of a tet, one per edge [radians].
std::array<double, 6> dihedral_angles(const std::array<Vec3, 4>& corners);

/// Returns the longest edge over the radius of the inscribed ball, relative to that of a regular tet, √24: 1 at best,
/// without an upper bound (Parthasarathy, Graichen & Hathaway 1994, their α).
double aspect_ratio(const std::array<Vec3, 4>& corners);

/// Returns the quality of a soup with positively oriented tets.
MeshQuality mesh_quality(const TetSoup& soup);

/// Returns a table of several lines for readers.
std::string quality_text(const MeshQuality& quality);

}  // namespace griffith
