#include "sim/geometry/triangle.h"

namespace griffith {

std::optional<double> triangle_hit(const Vec3& origin, const Vec3& direction, const Vec3& a, const Vec3& b,
                                   const Vec3& c) {
  const Vec3 ab = b - a, ac = c - a, across = direction.cross(ac), from_a = origin - a;
  const double determinant = ab.dot(across);
  if (determinant == 0) return std::nullopt;
  const double u = from_a.dot(across) / determinant;
  const Vec3 turned = from_a.cross(ab);
  const double v = direction.dot(turned) / determinant;
  const double t = ac.dot(turned) / determinant;
  if (!(u >= 0 && v >= 0 && u + v <= 1 && t > 0)) return std::nullopt;
  return t;
}

}  // namespace griffith
