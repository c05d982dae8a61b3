#include "app/editor/shooting.h"

#include <algorithm>
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
  // Solve target − muzzle = v t + g t²/2 with |v| = speed, a quadratic equation in t²; its smaller root is the flat
  // arc.
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

ui::Aim flight_of(const ProjectileBurst& shot, const Vec3& target, const Vec3& gravity, const Frame& frame,
                  const std::optional<Ground>& ground) {
  constexpr int kPartsToTarget = 16, kMostParts = 24;
  ui::Aim aim{{shot.position}, 0, false};
  if (shot.speed <= 0) return aim;
  const double part = (target - shot.position).norm() / shot.speed / kPartsToTarget;
  for (int i = 1; i <= kMostParts && !aim.hits; ++i) {
    const double time = i * part;
    const Vec3 start = aim.flight.back();
    const Vec3 way = shot.position + time * shot.speed * shot.direction + time * time / 2 * gravity - start;
    const double met = surface_hit(frame, ground, start, way).value_or(2);
    aim.hits = met <= 1;
    aim.duration += std::min(met, 1.0) * part;
    aim.flight.push_back(start + std::min(met, 1.0) * way);
  }
  return aim;
}

}  // namespace griffith::app
