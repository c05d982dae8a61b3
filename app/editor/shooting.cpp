#include "app/editor/shooting.h"

#include <cmath>

#include "ui/model/surface_hit.h"

namespace griffith::app {

std::optional<double> surface_hit(const Frame& frame, const std::optional<Ground>& ground, const Vec3& origin,
                                  const Vec3& direction) {
  const std::optional<ui::SurfaceHit> hit = ui::first_surface_hit(frame, origin, direction);
  std::optional<double> nearest;
  if (hit) nearest = hit->distance;
  if (ground && direction.y() != 0) {
    const double t = (ground->height - origin.y()) / direction.y();
    if (t > 0 && (!nearest || t < *nearest)) nearest = t;
  }
  return nearest;
}

ProjectileBurst aimed_shot(ProjectileBurst shot, const Vec3& muzzle, const Vec3& target, const Vec3& gravity) {
  // target − muzzle = v t + g t²/2 with |v| = speed is a quadratic equation in t²; its smaller root is the flat arc.
  const Vec3 way = target - muzzle;
  const double b = way.dot(gravity) + shot.speed * shot.speed;
  const double discriminant = b * b - gravity.squaredNorm() * way.squaredNorm();
  shot.start = 0;
  shot.position = muzzle;
  shot.direction = way;
  if (discriminant >= 0 && b > 0) {
    const double time_squared = 2 * way.squaredNorm() / (b + std::sqrt(discriminant));
    shot.direction = way - gravity * time_squared / 2;
  }
  if (shot.direction.squaredNorm() == 0) shot.direction = -Vec3::UnitZ();
  shot.direction.normalize();
  return shot;
}

}  // namespace griffith::app
