#include "app/picture/glyph_shape.h"

#include <algorithm>
#include <cmath>

namespace griffith::app {
namespace {

/// Returns orthonormal axes, the first one along `direction`.
Mat3 axes_along(const Vec3& direction) {
  Mat3 axes;
  axes.col(0) = direction.normalized();
  axes.col(1) = axes.col(0).unitOrthogonal();
  axes.col(2) = axes.col(0).cross(axes.col(1));
  return axes;
}

}  // namespace

void add_arrow(std::vector<render::Glyph>& arrows, const Vec3& start, const Vec3& way, double thickness,
               const render::Rgb& color, std::int32_t id) {
  const double length = way.norm();
  if (!(length > 0) || !std::isfinite(length) || !start.allFinite()) return;
  const double radius = std::min(thickness, 0.25 * length);
  const Mat3 axes = axes_along(way) * Vec3(length, radius, radius).asDiagonal();
  arrows.push_back({start.cast<float>(), axes.cast<float>(), color, 1, id});
}

render::Glyph disc(const Vec3& center, const Vec3& normal, double radius, const render::Rgb& color, float opacity) {
  return {center.cast<float>(), (radius * axes_along(normal)).cast<float>(), color, opacity, render::kNoId};
}

render::Glyph ball(const Vec3& center, double radius, const render::Rgb& color) {
  return {center.cast<float>(), (radius * Mat3::Identity()).cast<float>(), color, 1, render::kNoId};
}

}  // namespace griffith::app
