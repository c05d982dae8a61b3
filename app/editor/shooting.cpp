#include "app/editor/shooting.h"

#include <cmath>

#include "sim/geometry/triangle_hit.h"
#include "sim/mesh/tet_mesh.h"

namespace griffith::app {

std::optional<double> surface_hit(const Frame& frame, const std::optional<Ground>& ground, const Vec3& origin,
                                  const Vec3& direction) {
  std::optional<double> nearest;
  const auto keep = [&nearest](std::optional<double> t) {
    if (t && (!nearest || *t < *nearest)) nearest = t;
  };
  for (std::size_t tet = 0; tet < frame.elements.tets.size(); ++tet) {
    for (std::size_t face = 0; face < 4; ++face) {
      if (frame.elements.neighbours[tet][face].valid()) continue;
      const auto corner = [&](std::size_t i) {
        const NodeId node = frame.elements.tets[tet][static_cast<std::size_t>(kTetFaces[face][i])];
        return frame.nodes.positions[static_cast<std::size_t>(node.value)];
      };
      keep(triangle_hit(origin, direction, corner(0), corner(1), corner(2)));
    }
  }
  if (ground && direction.y() != 0) {
    const double t = (ground->height - origin.y()) / direction.y();
    if (t > 0) keep(t);
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
