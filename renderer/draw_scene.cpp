#include "renderer/draw_scene.h"

#include <cmath>

namespace griffith::render {

Eigen::AlignedBox3f bounds(const DrawScene& scene) {
  Eigen::AlignedBox3f box;
  const auto add = [&box](const Eigen::Vector3f& place, float radius) {
    if (!place.allFinite() || !std::isfinite(radius)) return;
    box.extend(place - Eigen::Vector3f::Constant(radius));
    box.extend(place + Eigen::Vector3f::Constant(radius));
  };
  for (const auto* places : {&scene.surface.positions, &scene.embedded.points})
    for (const Eigen::Vector3f& place : *places)
      if (place.allFinite()) box.extend(place);
  for (const Sphere& sphere : scene.spheres) add(sphere.center, sphere.radius);
  for (const Line& line : scene.lines) {
    add(line.start, 0);
    add(line.end, 0);
  }
  for (const Point& point : scene.points) add(point.position, 0);
  for (const auto* glyphs : {&scene.glyphs.arrows, &scene.glyphs.balls, &scene.glyphs.discs, &scene.glyphs.boxes})
    for (const Glyph& glyph : *glyphs) add(glyph.center, glyph.axes.colwise().norm().maxCoeff());
  return box;
}

}  // namespace griffith::render
