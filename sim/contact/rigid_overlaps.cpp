#include "sim/contact/rigid_overlaps.h"

#include <algorithm>

namespace griffith::contact {
namespace {

/// Multiple of the remaining overlap from which on the whole share goes: less of small ones, so that rocking objects
/// come to rest.
constexpr double kFullyPushed = 4;
constexpr int kPushSweeps = 10;

void push_sides_apart(std::span<Motion> motions, RigidRows& rows, const Block& block) {
  Motion &a = motions[block.a], &b = motions[block.b];
  if (!block.overlaps && !a.is_pushed_out() && !b.is_pushed_out()) return;
  for (int i = block.begin; i < block.end; ++i) {
    Point& point = rows.points[i];
    const double moved = dot(block.normal, a.push_velocity + cross(a.push_spin, point.arm_a) - b.push_velocity -
                                               cross(b.push_spin, point.arm_b));
    const double next = std::max(0.0, point.pushed + point.inverse_normal * (point.target - moved)),
                 pushed = next - point.pushed;
    if (pushed == 0) continue;
    point.pushed = next;
    a.push_out(point.arm_a, pushed * block.normal);
    b.push_out(point.arm_b, -pushed * block.normal);
  }
}

void push_group_apart(std::span<RigidBody> bodies, std::span<Motion> motions, std::span<const RigidContact> contacts,
                      const RigidGroup& group, double share) {
  RigidRows rows(motions, contacts, group, 1);
  for (Point& point : rows.points) point.gap = point.distance;
  push_apart(motions, rows, share);
  for (const Block& block : rows.blocks)
    for (const int side : {block.a, block.b}) {
      if (!motions[side].moves) continue;
      bodies[side].push = motions[side].push_velocity.vector();
      bodies[side].push_rotation = motions[side].push_spin.vector();
    }
}

}  // namespace

void push_apart(std::span<Motion> motions, RigidRows& rows, double share) {
  bool any = false;
  for (Block& block : rows.blocks) {
    for (int i = block.begin; i < block.end; ++i) {
      Point& point = rows.points[i];
      const double overlap = -point.resting - point.gap;
      const double share_of_it = share * std::min(1.0, overlap / (kFullyPushed * point.resting));
      point.target = overlap > 0 ? share_of_it * overlap : overlap;
      block.overlaps |= overlap > 0;
    }
    any |= block.overlaps;
  }
  for (int sweep = 0; any && sweep < kPushSweeps; ++sweep)
    rows.for_each_block([&](const Block& block) { push_sides_apart(motions, rows, block); });
}

void push_apart(std::span<RigidBody> bodies, std::span<const RigidContact> contacts, std::span<const RigidGroup> groups,
                double share) {
  std::vector<Motion> motions = motions_of(bodies);
  parallel_for(static_cast<int>(groups.size()), 1, [&](int begin, int end) {
    for (int i = begin; i < end; ++i) push_group_apart(bodies, motions, contacts, groups[i], share);
  });
}

}  // namespace griffith::contact
