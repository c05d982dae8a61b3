#include "sim/splinters/object_cell.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "sim/core/error.h"
#include "sim/core/number_text.h"

namespace griffith {
namespace {

/// Returns the distinct planes of an object's triangles, from the largest triangle of each, which is most accurate.
std::vector<HalfSpace> planes_of(const TriangleSurface& surface, const Vec3& center, double tolerance) {
  constexpr double kNearlyParallel = 0.999;
  std::vector<int> order(surface.triangles.size());
  std::iota(order.begin(), order.end(), 0);
  const auto size = [&](int triangle) { return -area_vector(corners_of(surface, triangle)).norm(); };
  std::ranges::stable_sort(order, {}, size);
  std::vector<HalfSpace> planes;
  for (const int triangle : order) {
    const std::array<Vec3, 3> corners = corners_of(surface, triangle);
    Vec3 normal = griffith::area_vector(corners);
    if (normal.norm() <= tolerance * tolerance) continue;
    normal.normalize();
    if (normal.dot(corners[0] - center) < 0) normal = -normal;
    const bool known = std::ranges::any_of(planes, [&](const HalfSpace& plane) {
      return plane.normal.dot(normal) > kNearlyParallel && std::ranges::all_of(corners, [&](const Vec3& corner) {
               return std::abs(plane.distance(corner)) <= tolerance;
             });
    });
    if (!known) planes.push_back({normal, normal.dot(corners[0])});
  }
  return planes;
}

/// Returns a tet that contains the box with a wide margin.
ConvexPolyhedron far_around(const Eigen::AlignedBox3d& box) {
  const double reach = 20 * box.diagonal().norm();
  const Vec3 center = box.center();
  return tet_polyhedron({center + Vec3(reach, reach, reach), center + Vec3(-reach, -reach, reach),
                         center + Vec3(-reach, reach, -reach), center + Vec3(reach, -reach, -reach)});
}

void require_convex(const ObjectCell& cell, const TriangleSurface& surface, double tolerance,
                    const std::string& where) {
  for (const HalfSpace& plane : cell.planes)
    for (const Vec3& point : surface.points) {
      if (plane.distance(point) <= 4 * tolerance) continue;
      throw InputError(where, "is not convex: its corner " + place_text(point) + " lies in front of one of its faces",
                       "cut it into convex cells, each an object of its own");
    }
}

/// Throws unless the triangles have the area of the cell's faces: none is missing or duplicate.
void require_closed(const ObjectCell& cell, const TriangleSurface& surface, const std::string& where) {
  constexpr double kFraction = 1e-3;
  double area = 0;
  bool bounded = !cell.polyhedron.empty();
  for (const PolyhedronFace& face : cell.polyhedron.faces) {
    bounded = bounded && face.wall >= 0;
    area += area_vector(cell.polyhedron, face).norm();
  }
  if (!bounded || std::abs(surface_area(surface) - area) > kFraction * area)
    throw InputError(where, "is not closed: faces are missing, or there twice",
                     "give each cell its whole surface once");
}

}  // namespace

ObjectCell object_cell(const SurfaceObject& object, double tolerance, const std::string& file) {
  const std::string where = file + ", cell \"" + object.name + "\"";
  TriangleSurface surface = object.surface;
  weld_points(surface);
  ObjectCell cell{object.name, {}, {}, bounds(surface)};
  Vec3 center = Vec3::Zero();
  for (const Vec3& point : surface.points) center += point / static_cast<double>(surface.points.size());
  cell.planes = planes_of(surface, center, tolerance);
  const bool flat = std::ranges::all_of(cell.planes, [&](const HalfSpace& plane) {
    return std::ranges::all_of(surface.points, [&](const Vec3& p) { return std::abs(plane.distance(p)) <= tolerance; });
  });
  if (flat) throw InputError(where, "has no volume", "give it a thickness, or remove it");
  require_convex(cell, surface, tolerance, where);
  cell.polyhedron = far_around(cell.box);
  for (std::size_t i = 0; i < cell.planes.size() && !cell.polyhedron.empty(); ++i)
    clip(cell.polyhedron, cell.planes[i], static_cast<int>(i), tolerance);
  require_closed(cell, surface, where);
  return cell;
}

ConvexPolyhedron common_part(const ObjectCell& a, const ObjectCell& b, double tolerance) {
  ConvexPolyhedron part = a.polyhedron;
  for (std::size_t i = 0; i < b.planes.size() && !part.empty(); ++i)
    clip(part, {b.planes[i].normal, b.planes[i].offset - tolerance}, static_cast<int>(i), tolerance);
  return part;
}

}  // namespace griffith
