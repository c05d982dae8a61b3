#include <algorithm>

#include "sim/explicit/four_sides.h"
#include "sim/explicit/microstep_contacts.h"

namespace griffith::explicit_dynamics {
namespace {

NodesOfSides nodes_of(const ExplicitBodies& bodies, const CrackSides& crack) {
  NodesOfSides sides;
  for (int i = 0; i < 3; ++i) {
    sides.first[i] = bodies.corner(crack.first_slot, crack.first_corners[i]);
    sides.second[i] = bodies.corner(crack.second_slot, crack.second_corners[i]);
  }
  return sides;
}

/// Gaps between the sides of four cracks at the center of the first side of each.
struct FourGaps {
  FourVectors normals;                 ///< unit normals out of the first sides
  std::array<DoubleLanes, 3> weights;  ///< weights of the second sides' corners
  DoubleLanes clear;                   ///< distance that they may still approach without contact [m]
  DoubleMask are_pressing;
};

/// The corners of the first sides are counterclockwise seen from outside.
FourGaps gaps_between(const FourSides& first, const FourSides& second) {
  FourGaps gaps;
  const FourVectors area = DoubleLanes{0.5, 0.5, 0.5, 0.5} * double_areas(first);
  const DoubleLanes size = simd::root(dot(area, area));
  gaps.normals = area / size;
  const FourVectors center = (first[0] + first[1] + first[2]) / DoubleLanes{3, 3, 3, 3};
  const FourVectors across = double_areas(second);
  const DoubleLanes square = dot(across, across);
  gaps.weights = weights_in(second, across, square, center);
  DoubleLanes gap = -dot(gaps.normals, center);
  for (int i = 0; i < 3; ++i) gap += gaps.weights[i] * dot(gaps.normals, second[i]);
  const DoubleLanes least = smaller(smaller(gaps.weights[0], gaps.weights[1]), gaps.weights[2]);
  const DoubleMask are_opposite = least >= 0.0;
  gaps.clear = are_opposite ? gap : distance_beyond(second, square, -least);
  gaps.are_pressing = are_opposite & (gap <= 0.0) & (gap * gap <= size);
  return gaps;
}

}  // namespace

/// Stops the closing sides of a crack without rebound, at the center of the first, so that no torque arises. Sides that
/// have slid apart are left to the contacts of whole pieces.
void MicrostepContacts::close_cracks(ExplicitBodies& bodies) {
  std::array<WatchedCrack*, simd::kDoubleLanes> four;
  int count = 0;
  const auto close = [&] {
    std::fill(four.begin() + count, four.end(), four[0]);
    const auto sides = [&](int lane) { return nodes_of(bodies, four[lane]->sides); };
    const FourGaps gaps = gaps_between(four_sides(bodies, [&](int lane) { return sides(lane).first; }),
                                       four_sides(bodies, [&](int lane) { return sides(lane).second; }));
    for (int lane = 0; lane < count; ++lane) {
      record_gap(*four[lane], gaps.clear[lane]);
      if (gaps.are_pressing[lane] == 0) continue;
      const Vec3 weights(gaps.weights[0][lane], gaps.weights[1][lane], gaps.weights[2][lane]);
      push_apart(bodies, sides(lane), vector_of(gaps.normals, lane), weights);
    }
    count = 0;
  };
  for (WatchedCrack& crack : cracks_) {
    if (is_clear(crack)) continue;
    four[count++] = &crack;
    if (count == simd::kDoubleLanes) close();
  }
  if (count > 0) close();
}

/// `normal`: out of the first side; `weights`: those of the second side's corners at the center of the first.
void MicrostepContacts::push_apart(ExplicitBodies& bodies, const NodesOfSides& sides, const Vec3& normal,
                                   const Vec3& weights) {
  const auto opening_speed = [&] {
    double speed = 0;
    for (int i = 0; i < 3; ++i)
      speed += normal.dot(weights[i] * bodies.velocity(sides.second[i]) - bodies.velocity(sides.first[i]) / 3);
    return speed;
  };
  const double speed = opening_speed();
  if (speed >= 0) return;
  double mobility = 0;
  for (int i = 0; i < 3; ++i)
    mobility += bodies.mobility(sides.first[i], normal) / 9 +
                weights[i] * weights[i] * bodies.mobility(sides.second[i], normal);
  if (mobility == 0) return;
  const Vec3 impulse = speed / mobility * normal;
  for (int i = 0; i < 3; ++i) {
    push_node(bodies, sides.first[i], impulse / 3);
    push_node(bodies, sides.second[i], -weights[i] * impulse);
  }
  // If both sides end in one node, at the front, they do not separate: more speed is left than the others lost.
  lost_ += 0.5 * speed / mobility * (speed + opening_speed());
}

}  // namespace griffith::explicit_dynamics
