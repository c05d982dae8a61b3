#pragma once

#include <string>
#include <vector>

#include "sim/meshing/self_intersection.h"
#include "sim/meshing/surface.h"

namespace griffith {

/// Findings and changes of prepare_surface().
struct SurfaceReport {
  int points = 0, triangles = 0;  ///< counts after the repairs
  int removed_triangles = 0;  ///< triangles with a repeated corner, or with the corners of an earlier triangle; removed
  int flat_triangles = 0;     ///< triangles of almost no area for their length; kept
  int flipped_triangles = 0;  ///< triangles with another orientation than their neighbors; flipped
  int inverted_shells = 0;    ///< closed shells that were inside out; inverted
  int one_sided_shells = 0;   ///< shells that cannot be oriented, such as a Möbius strip
  int boundary_edges = 0;     ///< edges of only one triangle: a hole
  int boundary_loops = 0;     ///< parts of the boundary
  int crowded_edges = 0;      ///< edges of more than two triangles
  int pinched_points = 0;     ///< points joining parts of the surface that share no edge there
  int shells = 0;             ///< parts connected through edges
  SelfIntersections self_intersections;
  Vec3 first_boundary = Vec3::Zero(), first_crowded = Vec3::Zero(), first_pinched = Vec3::Zero();  ///< positions [m]
  double volume = 0, area = 0;                          ///< [m³], [m²]; the volume of an open surface is meaningless
  Vec3 minimum = Vec3::Zero(), maximum = Vec3::Zero();  ///< bounding box [m]

  /// True if the surface separates inside and outside without ambiguity.
  bool closed() const { return boundary_edges == 0 && crowded_edges == 0 && one_sided_shells == 0; }
  /// Returns the diagonal of the bounding box [m].
  double size() const { return (maximum - minimum).norm(); }
};

/// Repairs a surface as far as it is safe: removes repeated triangles, flips triangles and inverts closed shells with
/// the wrong orientation, but keeps a shell inside another one as a cavity. Reports all other findings. `name` (a file)
/// begins the messages. Throws InputError if no triangle is left.
SurfaceReport prepare_surface(TriangleSurface& surface, const std::string& name = "surface");

/// Returns one sentence per finding; empty if there are none.
std::vector<std::string> findings(const SurfaceReport& report);

}  // namespace griffith
