#include "sim/geometry/polygon.h"

#include <numeric>

namespace griffith {
namespace {

/// Returns Newell's normal, correct also for polygons that are neither plane nor convex.
Vec3 normal_of(std::span<const Vec3> corners) {
  Vec3 normal = Vec3::Zero();
  for (std::size_t i = 0; i < corners.size(); ++i)
    normal += (corners[i] - corners[0]).cross(corners[(i + 1) % corners.size()] - corners[0]);
  return normal;
}

double turn(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& normal) {
  return normal.dot((b - a).cross(c - a));
}

/// True if the corner at `place` of the loop is convex and no other corner lies in its triangle.
bool is_ear(std::span<const Vec3> corners, const std::vector<int>& loop, std::size_t place, const Vec3& normal) {
  const std::size_t count = loop.size();
  const Vec3 &a = corners[loop[(place + count - 1) % count]], &b = corners[loop[place]],
             &c = corners[loop[(place + 1) % count]];
  if (turn(a, b, c, normal) <= 0) return false;
  for (std::size_t i = 2; i + 1 < count; ++i) {
    const Vec3& p = corners[loop[(place + i) % count]];
    if (turn(a, b, p, normal) >= 0 && turn(b, c, p, normal) >= 0 && turn(c, a, p, normal) >= 0) return false;
  }
  return true;
}

}  // namespace

std::vector<std::array<int, 3>> triangulate(std::span<const Vec3> corners) {
  std::vector<std::array<int, 3>> triangles;
  std::vector<int> loop(corners.size());
  std::iota(loop.begin(), loop.end(), 0);
  const Vec3 normal = normal_of(corners);
  while (loop.size() >= 3) {
    const std::size_t count = loop.size();
    std::size_t ear = 0;
    while (ear < count && !is_ear(corners, loop, ear, normal)) ++ear;
    if (ear == count) ear = 1;  // a polygon that crosses itself: any corner is as good
    triangles.push_back({loop[(ear + count - 1) % count], loop[ear % count], loop[(ear + 1) % count]});
    loop.erase(loop.begin() + static_cast<std::ptrdiff_t>(ear % count));
  }
  return triangles;
}

}  // namespace griffith
