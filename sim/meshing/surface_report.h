#pragma once

#include <string>
#include <vector>

#include "sim/meshing/self_intersection.h"
#include "sim/meshing/surface.h"

namespace griffith {

/// What prepare_surface() found and what it changed.
struct SurfaceReport {
  int points = 0, triangles = 0;  ///< after the repairs
  int removed_triangles = 0;      ///< had a corner twice, or the corners of an earlier triangle; removed
  int flat_triangles = 0;         ///< have next to no area for their length; kept
  int flipped_triangles = 0;      ///< faced the other way than their neighbours; turned
  int inverted_shells = 0;        ///< closed shells that were inside out; turned
  int one_sided_shells = 0;       ///< cannot be oriented, such as a Möbius strip
  int boundary_edges = 0;         ///< belong to one triangle alone: a hole
  int boundary_loops = 0;         ///< parts into which they fall
  int crowded_edges = 0;          ///< belong to more than two triangles
  int pinched_points = 0;         ///< join parts of the surface that share no edge there
  int shells = 0;                 ///< parts that hold together through edges
  SelfIntersections self_intersections;
  Vec3 first_boundary = Vec3::Zero(), first_crowded = Vec3::Zero(), first_pinched = Vec3::Zero();  ///< places [m]
  double volume = 0, area = 0;                          ///< [m³], [m²]; the volume of an open surface means nothing
  Vec3 minimum = Vec3::Zero(), maximum = Vec3::Zero();  ///< bounding box [m]

  /// Whether the surface parts an inside from an outside without a doubt.
  bool closed() const { return boundary_edges == 0 && crowded_edges == 0 && one_sided_shells == 0; }
  /// The length of the bounding box's diagonal [m].
  double size() const { return (maximum - minimum).norm(); }
};

/// Makes a surface as sound as safe repairs make it (drops repeated triangles, turns triangles and closed shells that
/// face the wrong way; a shell inside another one is left as a cavity) and finds what else is wrong with it. `name` (a
/// file) begins the messages. Throws InputError when no triangle is left.
SurfaceReport prepare_surface(TriangleSurface& surface, const std::string& name = "surface");

/// One sentence a finding, for people; empty when there is nothing to tell.
std::vector<std::string> findings(const SurfaceReport& report);

}  // namespace griffith
