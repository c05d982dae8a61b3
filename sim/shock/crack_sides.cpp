#include <Eigen/Geometry>

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

/// Three times the mean gap between two sides; they had the same place at rest.
Vec3 gap(const Solid& solid, const Sides& sides) {
  Vec3 sum = Vec3::Zero();
  for (int i = 0; i < 3; ++i) sum += solid.displacement(sides.second[i]) - solid.displacement(sides.first[i]);
  return sum;
}

Vec3 opening_speed(const Solid& solid, const Sides& sides) {
  Vec3 sum = Vec3::Zero();
  for (int i = 0; i < 3; ++i) sum += solid.velocity(sides.second[i]) - solid.velocity(sides.first[i]);
  return sum;
}

/// The area vector of the first side, out of it: its corners are counter-clockwise seen from outside.
Vec3 area_of(const Solid& solid, const Sides& sides) {
  const Vec3 a = solid.position(sides.first[0]);
  return 0.5 * (solid.position(sides.first[1]) - a).cross(solid.position(sides.first[2]) - a);
}

}  // namespace

/// The sides of a crack that close on each other meet without rebound, face by face, where they parted. Those that have
/// slid apart by more than their size are left to the contacts of whole pieces.
void Impacts::close_cracks(Solid& solid) {
  for (const CrackSides& crack : cracks_) {
    const Sides sides = nodes_of(solid, crack);
    const Vec3 apart = gap(solid, sides), area = area_of(solid, sides);
    if (apart.dot(area) > 0) continue;
    const double size = area.norm();
    const Vec3 normal = area / size;
    const double speed = opening_speed(solid, sides).dot(normal);
    if (speed >= 0 || apart.squaredNorm() > size) continue;
    double mobility = 0;
    for (int i = 0; i < 3; ++i)
      mobility += solid.mobility(sides.first[i], normal) + solid.mobility(sides.second[i], normal);
    if (mobility == 0) continue;
    const Vec3 impulse = speed / mobility * normal;
    for (int i = 0; i < 3; ++i) {
      push_node(solid, sides.first[i], impulse);
      push_node(solid, sides.second[i], -impulse);
    }
    // Where both sides end in one node, at the front, they do not part: more speed is left than the others lost.
    lost_ += 0.5 * impulse.dot(speed * normal + opening_speed(solid, sides));
  }
}

}  // namespace griffith::shock
