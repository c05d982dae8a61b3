#pragma once

#include <array>
#include <filesystem>
#include <vector>

#include "sim/core/linear_algebra.h"
#include "sim/core/monitor.h"

namespace griffith {

/// Triangles in space, as read or made: not yet known to enclose anything (see prepare_surface() in surface_report.h).
struct TriangleSurface {
  std::vector<Vec3> points;                   ///< [m]
  std::vector<std::array<int, 3>> triangles;  ///< indices into `points`, counter-clockwise seen from outside
  std::vector<std::array<Vec2, 3>> uvs;       ///< per triangle and corner; empty: none
  std::vector<std::array<Vec3, 3>> normals;   ///< per triangle and corner, of unit length; empty: none
};

/// Reads a surface from .obj, .stl, .ply, .off, .gltf or .glb, all its objects together, polygons cut into triangles;
/// coordinates are multiplied by `scale` and equal points become one. Throws InputError when the file is missing, of
/// another format, cannot be read, or holds no triangles or a coordinate that is not finite; Cancelled when the monitor
/// says so.
TriangleSurface read_surface(const std::filesystem::path& path, double scale = 1, const Monitor& monitor = {});

/// Makes one point of points with equal coordinates and drops points that no triangle uses. The first of equal points
/// keeps its place in the order.
void weld_points(TriangleSurface& surface);

/// The corners of a triangle.
inline std::array<Vec3, 3> corners_of(const TriangleSurface& surface, int triangle) {
  const auto& [a, b, c] = surface.triangles[triangle];
  return {surface.points[a], surface.points[b], surface.points[c]};
}

/// Half the cross product of two edges: normal to the triangle, as long as its area [m²].
inline Vec3 area_vector(const std::array<Vec3, 3>& corners) {
  return (corners[1] - corners[0]).cross(corners[2] - corners[0]) / 2;
}

/// The box round all points.
Eigen::AlignedBox3d bounds(const TriangleSurface& surface);
/// The volume inside [m³], by the divergence theorem: negative when the triangles are seen from inside; without a
/// meaning for a surface with holes.
double enclosed_volume(const TriangleSurface& surface);
/// The sum of all areas [m²].
double surface_area(const TriangleSurface& surface);

}  // namespace griffith
