#include "ui/model/view_camera.h"

namespace griffith::ui {

ViewRay ViewCamera::ray(const Vec2& pixel) const {
  const double per_pixel = 2 * tangent / height;
  const double x = (pixel.x() - width / 2) * per_pixel, y = (height / 2 - pixel.y()) * per_pixel;
  return {eye, (forward + x * right + y * up).normalized()};
}

std::optional<Vec2> ViewCamera::pixel(const Vec3& point) const {
  constexpr double kNearest =
      1e-6;  // fraction of the distance below which a point counts as level with the eye and is not visible
  const Vec3 arm = point - eye;
  const double depth = arm.dot(forward);
  if (depth <= kNearest * arm.norm()) return std::nullopt;
  const double per_pixel = 2 * tangent / height * depth;
  return Vec2(width / 2 + arm.dot(right) / per_pixel, height / 2 - arm.dot(up) / per_pixel);
}

double ViewCamera::pixel_length(const Vec3& point) const { return 2 * tangent / height * (point - eye).dot(forward); }

}  // namespace griffith::ui
