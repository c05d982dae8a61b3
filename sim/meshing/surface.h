#pragma once

#include <array>
#include <filesystem>
#include <vector>

#include "sim/core/linear_algebra.h"
#include "sim/core/monitor.h"

namespace griffith {

/// Triangles in space as read or made. They may not enclose anything (see prepare_surface() in surface_report.h).
struct TriangleSurface {
  std::vector<Vec3> points;                   ///< [m]
  std::vector<std::array<int, 3>> triangles;  ///< indices into `points`, counterclockwise seen from outside
  std::vector<std::array<Vec2, 3>> uvs;       ///< per triangle and corner; empty: none
  std::vector<std::array<Vec3, 3>> normals;   ///< per triangle and corner, of unit length; empty: none
  bool operator==(const TriangleSurface&) const = default;
};

/// Reads a surface with all its objects from .obj, .stl, .ply, .off, .gltf or .glb. Polygons are cut into triangles,
/// coordinates are multiplied by `scale`, and equal points are merged. Throws InputError if the file is missing, of
/// another format or unreadable, or if it has no triangles or a coordinate that is not finite. Throws Cancelled when
/// the monitor cancels.
TriangleSurface read_surface(const std::filesystem::path& path, double scale = 1, const Monitor& monitor = {});

/// Merges points with equal coordinates and drops points without a triangle. The first of equal points keeps its place
/// in the order.
void weld_points(TriangleSurface& surface);

/// Returns the corners of a triangle.
inline std::array<Vec3, 3> corners_of(const TriangleSurface& surface, int triangle) {
  const auto& [a, b, c] = surface.triangles[triangle];
  return {surface.points[a], surface.points[b], surface.points[c]};
}

/// Returns half the cross product of two edges: normal to the triangle, with its area as length [m²].
inline Vec3 area_vector(const std::array<Vec3, 3>& corners) {
  return (corners[1] - corners[0]).cross(corners[2] - corners[0]) / 2;
}

/// Returns the box around all points.
Eigen::AlignedBox3d bounds(const TriangleSurface& surface);
/// Returns the enclosed volume [m³] by the divergence theorem: negative if the triangles are inside out; meaningless
/// for a surface with holes.
double enclosed_volume(const TriangleSurface& surface);
/// Returns the sum of all areas [m²].
double surface_area(const TriangleSurface& surface);

}  // namespace griffith
