#include "app/bake/object_mesh.h"

#include <map>

#include "sim/splinters/convex_polyhedron.h"

namespace griffith::app {
namespace {

/// Returns texture coordinates of a point without any: its projection along the dominant axis of its face normal [m].
Vec2 box_projection(const Vec3& point, const Vec3& normal) {
  int axis = 0;
  normal.cwiseAbs().maxCoeff(&axis);
  if (axis == 0) return {point.z(), point.y()};
  if (axis == 1) return {point.x(), point.z()};
  return {point.x(), point.y()};
}

/// Adds a triangle fan: polygons are convex.
void add_triangles(std::vector<std::array<int, 3>>& triangles, const std::vector<int>& polygon) {
  for (std::size_t i = 2; i < polygon.size(); ++i) triangles.push_back({polygon[0], polygon[i - 1], polygon[i]});
}

/// An icosphere of unit radius, after two subdivisions of all edges.
struct Icosphere {
  std::vector<Vec3> points;
  std::vector<std::array<int, 3>> triangles;
};

Icosphere icosahedron() {
  const double g = (1 + std::sqrt(5.0)) / 2;
  Icosphere sphere{{{-1, g, 0},
                    {1, g, 0},
                    {-1, -g, 0},
                    {1, -g, 0},
                    {0, -1, g},
                    {0, 1, g},
                    {0, -1, -g},
                    {0, 1, -g},
                    {g, 0, -1},
                    {g, 0, 1},
                    {-g, 0, -1},
                    {-g, 0, 1}},
                   {{0, 11, 5},  {0, 5, 1},  {0, 1, 7},  {0, 7, 10}, {0, 10, 11}, {1, 5, 9}, {5, 11, 4},
                    {11, 10, 2}, {10, 7, 6}, {7, 1, 8},  {3, 9, 4},  {3, 4, 2},   {3, 2, 6}, {3, 6, 8},
                    {3, 8, 9},   {4, 9, 5},  {2, 4, 11}, {6, 2, 10}, {8, 6, 7},   {9, 8, 1}}};
  for (Vec3& point : sphere.points) point.normalize();
  return sphere;
}

void halve_edges(Icosphere& sphere) {
  std::map<std::pair<int, int>, int> middles;
  const auto middle = [&](int a, int b) {
    const auto [found, is_new] = middles.try_emplace(std::minmax(a, b), static_cast<int>(sphere.points.size()));
    if (is_new) sphere.points.push_back((sphere.points[a] + sphere.points[b]).normalized());
    return found->second;
  };
  std::vector<std::array<int, 3>> finer;
  for (const auto& [a, b, c] : sphere.triangles) {
    const int ab = middle(a, b), bc = middle(b, c), ca = middle(c, a);
    finer.insert(finer.end(), {{a, ab, ca}, {b, bc, ab}, {c, ca, bc}, {ab, bc, ca}});
  }
  sphere.triangles = std::move(finer);
}

BakedMesh sphere_mesh(double radius) {
  Icosphere sphere = icosahedron();
  for (int i = 0; i < 2; ++i) halve_edges(sphere);
  BakedMesh mesh;
  for (const Vec3& direction : sphere.points) {
    mesh.points.push_back(radius * direction);
    mesh.normals.push_back(direction);
    mesh.uvs.push_back(box_projection(radius * direction, direction));
  }
  mesh.triangles[static_cast<int>(Look::outside)] = std::move(sphere.triangles);
  return mesh;
}

}  // namespace

BakedMesh piece_mesh(const PieceSurface& surface, const Vec3& origin) {
  BakedMesh mesh;
  mesh.normals.resize(surface.points.size(), Vec3::UnitY());
  mesh.uvs.resize(surface.points.size(), Vec2::Zero());
  for (const Vec3& point : surface.points) mesh.points.push_back(point - origin);
  for (std::size_t i = 0; i < surface.polygons.size(); ++i) {
    std::vector<Vec3> corners;
    for (const int point : surface.polygons[i]) corners.push_back(surface.points[point]);
    const Vec3 flat = area_vector(corners).stableNormalized();
    const Look look = surface.looks[i];
    for (const int point : surface.polygons[i]) {
      const bool is_smooth = !surface.normals.empty() && surface.normals[point] != Vec3::Zero();
      if (is_smooth)
        mesh.normals[point] = surface.normals[point];
      else if (flat != Vec3::Zero())
        mesh.normals[point] = flat;
      mesh.uvs[point] = surface.uvs.empty() || look != Look::outside ? box_projection(surface.points[point], flat)
                                                                     : surface.uvs[point];
    }
    add_triangles(mesh.triangles[static_cast<int>(look)], surface.polygons[i]);
  }
  return mesh;
}

BakedMesh projectile_mesh(const ProjectileView& projectile) {
  if (projectile.corners.empty()) return sphere_mesh(projectile.radius);
  PieceSurface surface;
  for (const std::vector<int>& face : projectile.faces) {
    std::vector<int>& polygon = surface.polygons.emplace_back();
    for (const int corner : face) {
      polygon.push_back(static_cast<int>(surface.points.size()));
      surface.points.push_back(projectile.corners[corner]);
    }
  }
  surface.looks.resize(surface.polygons.size());
  return piece_mesh(surface, Vec3::Zero());
}

}  // namespace griffith::app
