#pragma once

#include <cmath>
#include <filesystem>
#include <fstream>
#include <numbers>
#include <string>

#include "sim/meshing/surface.h"

namespace griffith::testing {

/// A box with two triangles a side, seen from outside.
inline TriangleSurface box_surface(const Vec3& minimum, const Vec3& maximum) {
  TriangleSurface box;
  for (int i = 0; i < 8; ++i)
    box.points.emplace_back(i & 1 ? maximum.x() : minimum.x(), i & 2 ? maximum.y() : minimum.y(),
                            i & 4 ? maximum.z() : minimum.z());
  for (const auto& [a, b, c, d] :
       {std::array{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}}) {
    box.triangles.push_back({a, b, c});
    box.triangles.push_back({a, c, d});
  }
  return box;
}

/// A grid of rows × columns points, closed round in both directions where asked; point(row, column) places them.
template <class Point>
TriangleSurface grid_surface(int rows, int columns, bool rows_close, bool columns_close, const Point& point) {
  TriangleSurface surface;
  for (int i = 0; i < rows; ++i)
    for (int j = 0; j < columns; ++j) surface.points.push_back(point(i, j));
  for (int i = 0; i < (rows_close ? rows : rows - 1); ++i)
    for (int j = 0; j < (columns_close ? columns : columns - 1); ++j) {
      const auto at = [&](int row, int column) { return row % rows * columns + column % columns; };
      surface.triangles.push_back({at(i, j), at(i + 1, j), at(i + 1, j + 1)});
      surface.triangles.push_back({at(i, j), at(i + 1, j + 1), at(i, j + 1)});
    }
  return surface;
}

/// A torus about the z axis.
inline TriangleSurface torus_surface(double radius, double tube, int around, int across) {
  return grid_surface(around, across, true, true, [=](int i, int j) {
    const double u = 2 * std::numbers::pi * i / around, v = 2 * std::numbers::pi * j / across;
    const double r = radius + tube * std::cos(v);
    return Vec3(r * std::cos(u), r * std::sin(u), tube * std::sin(v));
  });
}

/// A sphere about the origin with `rings` rings; its poles are points.
inline TriangleSurface sphere_surface(double radius, int rings) {
  const int around = 2 * rings;
  TriangleSurface sphere = grid_surface(rings + 1, around, false, true, [=](int i, int j) {
    if (i == 0 || i == rings) return Vec3(0, 0, i == 0 ? radius : -radius);
    const double theta = std::numbers::pi * i / rings, phi = 2 * std::numbers::pi * j / around;
    return Vec3(radius * std::sin(theta) * std::cos(phi), radius * std::sin(theta) * std::sin(phi),
                radius * std::cos(theta));
  });
  weld_points(sphere);
  std::erase_if(sphere.triangles, [](const auto& t) { return t[0] == t[1] || t[1] == t[2] || t[2] == t[0]; });
  return sphere;
}

inline void move(TriangleSurface& surface, const Vec3& by) {
  for (Vec3& point : surface.points) point += by;
}

inline void turn_inside_out(TriangleSurface& surface) {
  for (auto& triangle : surface.triangles) std::swap(triangle[1], triangle[2]);
}

/// Both in one, nothing shared.
inline TriangleSurface together(TriangleSurface a, const TriangleSurface& b) {
  const int first = static_cast<int>(a.points.size());
  a.points.insert(a.points.end(), b.points.begin(), b.points.end());
  for (const auto& [i, j, k] : b.triangles) a.triangles.push_back({first + i, first + j, first + k});
  return a;
}

inline void write_off(const TriangleSurface& surface, const std::filesystem::path& path) {
  std::ofstream file(path);
  file.precision(9);
  file << "OFF\n" << surface.points.size() << ' ' << surface.triangles.size() << " 0\n";
  for (const Vec3& p : surface.points) file << p.x() << ' ' << p.y() << ' ' << p.z() << '\n';
  for (const auto& [a, b, c] : surface.triangles) file << "3 " << a << ' ' << b << ' ' << c << '\n';
}

/// An empty folder of the running test's own.
std::filesystem::path test_folder();

/// A surface of the scenes that come with the program.
std::filesystem::path shipped_surface(const std::string& name);

}  // namespace griffith::testing
