#pragma once

#include "app/output/export_pieces.h"
#include "renderer/draw_scene.h"
#include "sim/core/linear_algebra.h"

namespace griffith::app {

/// By the divergence theorem [m³]; right only if the surface is closed and faces outward.
inline double enclosed_volume(const render::Surface& surface) {
  double volume = 0;
  for (std::size_t i = 0; i < surface.positions.size(); i += 3) {
    const Vec3 a = surface.positions[i].cast<double>(), b = surface.positions[i + 1].cast<double>();
    volume += a.dot(b.cross(surface.positions[i + 2].cast<double>())) / 6;
  }
  return volume;
}

inline double enclosed_volume(const PieceSurface& surface) {
  double volume = 0;
  for (const std::vector<int>& polygon : surface.polygons)
    for (std::size_t i = 2; i < polygon.size(); ++i)
      volume += surface.points[polygon[0]].dot(surface.points[polygon[i - 1]].cross(surface.points[polygon[i]])) / 6;
  return volume;
}

}  // namespace griffith::app
