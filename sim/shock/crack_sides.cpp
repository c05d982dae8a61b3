#include <Eigen/Geometry>
#include <algorithm>

#include "sim/shock/impacts.h"

namespace griffith::shock {
namespace {

struct Sides {
  std::array<int, 3> first{}, second{};
};

Sides nodes_of(const Solid& solid, const CrackSides& crack) {
  Sides sides;
  for (int i = 0; i < 3; ++i) {
    sides.first[i] = solid.corner(crack.first_slot, crack.first_corners[i]);
    sides.second[i] = solid.corner(crack.second_slot, crack.second_corners[i]);
  }
  return sides;
}

Vec3 center_of(const Solid& solid, const std::array<int, 3>& nodes) {
  return (solid.position(nodes[0]) + solid.position(nodes[1]) + solid.position(nodes[2])) / 3;
}

std::array<double, 3> weights_in(const Solid& solid, const std::array<int, 3>& nodes, const Vec3& point) {
  const Vec3 a = solid.position(nodes[0]), b = solid.position(nodes[1]), c = solid.position(nodes[2]);
  const Vec3 normal = (b - a).cross(c - a);
  return weights_in_triangle(a, b, c, normal, normal.squaredNorm(), point);
}

/// The area vector of the first side, out of it: its corners are counter-clockwise seen from outside.
Vec3 area_of(const Solid& solid, const Sides& sides) {
  const Vec3 a = solid.position(sides.first[0]);
  return 0.5 * (solid.position(sides.first[1]) - a).cross(solid.position(sides.first[2]) - a);
}

}  // namespace

/// The sides of a crack that close on each other meet without rebound, at the centre of the first, so that no torque is
/// made. Those that have slid further apart are left to the contacts of whole pieces.
void Impacts::close_cracks(Solid& solid) {
  for (WatchedCrack& crack : cracks_) {
    if (is_clear(crack)) continue;
    const Sides sides = nodes_of(solid, crack.sides);
    const Vec3 area = area_of(solid, sides), center = center_of(solid, sides.first);
    const Vec3 normal = area.normalized();
    const std::array<double, 3> weights = weights_in(solid, sides.second, center);
    if (!std::ranges::all_of(weights, [](double weight) { return weight >= 0; })) continue;
    double gap = -normal.dot(center);
    for (int i = 0; i < 3; ++i) gap += weights[i] * normal.dot(solid.position(sides.second[i]));
    record_gap(crack, gap);
    if (gap > 0 || gap * gap > area.norm()) continue;
    const auto opening_speed = [&] {
      double speed = 0;
      for (int i = 0; i < 3; ++i)
        speed += normal.dot(weights[i] * solid.velocity(sides.second[i]) - solid.velocity(sides.first[i]) / 3);
      return speed;
    };
    const double speed = opening_speed();
    if (speed >= 0) continue;
    double mobility = 0;
    for (int i = 0; i < 3; ++i)
      mobility += solid.mobility(sides.first[i], normal) / 9 +
                  weights[i] * weights[i] * solid.mobility(sides.second[i], normal);
    if (mobility == 0) continue;
    const Vec3 impulse = speed / mobility * normal;
    for (int i = 0; i < 3; ++i) {
      push_node(solid, sides.first[i], impulse / 3);
      push_node(solid, sides.second[i], -weights[i] * impulse);
    }
    // Where both sides end in one node, at the front, they do not part: more speed is left than the others lost.
    lost_ += 0.5 * speed / mobility * (speed + opening_speed());
  }
}

}  // namespace griffith::shock
