#include <string>

#include "sim/core/error.h"
#include "sim/meshing/surface.h"
#include "sim/meshing/surface_objects.h"

namespace griffith {
namespace {

/// Appends an attribute of corners, zeros if the object has none.
template <class T>
void append_corners(std::vector<std::array<T, 3>>& all, const std::vector<std::array<T, 3>>& added, std::size_t count) {
  all.insert(all.end(), added.begin(), added.end());
  const T zero = T::Zero();
  all.resize(count, {zero, zero, zero});
}

TriangleSurface joined(const std::vector<SurfaceObject>& objects) {
  TriangleSurface all;
  bool has_uvs = false, has_normals = false;
  for (const auto& [name, surface] : objects) {
    const int first = static_cast<int>(all.points.size());
    all.points.insert(all.points.end(), surface.points.begin(), surface.points.end());
    for (const auto& [a, b, c] : surface.triangles) all.triangles.push_back({first + a, first + b, first + c});
    append_corners(all.uvs, surface.uvs, all.triangles.size());
    append_corners(all.normals, surface.normals, all.triangles.size());
    has_uvs = has_uvs || !surface.uvs.empty();
    has_normals = has_normals || !surface.normals.empty();
  }
  if (!has_uvs) all.uvs.clear();
  if (!has_normals) all.normals.clear();
  return all;
}

void require_finite(const TriangleSurface& surface, const std::filesystem::path& path) {
  for (std::size_t i = 0; i < surface.triangles.size(); ++i)
    for (const Vec3& corner : corners_of(surface, static_cast<int>(i)))
      if (!corner.allFinite())
        throw InputError(path.string(), "triangle " + std::to_string(i) + " has a coordinate that is not finite",
                         "export the surface again; look for nan and inf in the file");
}

}  // namespace

TriangleSurface read_surface(const std::filesystem::path& path, double scale, const Monitor& monitor) {
  TriangleSurface surface = joined(read_surface_objects(path, monitor));
  if (surface.triangles.empty())
    throw InputError(path.string(), "holds no triangles", "export the surface's faces, not only points or lines");
  for (Vec3& point : surface.points) point *= scale;
  require_finite(surface, path);
  weld_points(surface);
  return surface;
}

}  // namespace griffith
