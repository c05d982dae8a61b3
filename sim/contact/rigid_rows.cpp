#include "sim/contact/rigid_rows.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <bit>
#include <cmath>

namespace griffith::contact {
namespace {

Block block_of(const RigidContact& contact, int begin) {
  Block block;
  block.a = contact.a;
  block.b = contact.b;
  const Vec3 first = contact.normal.unitOrthogonal();
  block.normal = Triple(contact.normal);
  block.first = Triple(first);
  block.second = cross(block.normal, block.first);
  block.friction = contact.friction;
  block.begin = begin;
  return block;
}

void prepare(Point& point, const Block& block, const RigidContact& contact, const Motion& a, const Motion& b,
             double substep) {
  set_arms(point, block, Triple(contact.arm_a), Triple(contact.arm_b), a, b);
  point.distance = contact.distance;
  point.is_mean = contact.is_mean;
  point.resting = contact.resting;
  point.restitution = contact.restitution;
  point.approach = contact.approach;
  point.fall = contact.fall;
  const auto driven = [&](const Motion& motion, const Triple& arm) {
    return motion.moves ? 0 : dot(block.normal, motion.velocity + cross(motion.spin, arm));
  };
  point.driven = driven(a, point.arm_a) - driven(b, point.arm_b);
  const Triple start = substep * Triple(contact.force);
  point.normal = std::max(0.0, dot(block.normal, start));
  if (block.friction == 0) return;
  point.first = dot(block.first, start);
  point.second = dot(block.second, start);
}

}  // namespace

void set_arms(Point& point, const Block& block, const Triple& arm_a, const Triple& arm_b, const Motion& a,
              const Motion& b) {
  point.arm_a = arm_a;
  point.arm_b = arm_b;
  const Triple* const axes[3] = {&block.normal, &block.first, &block.second};
  Triple levers_a[3], levers_b[3];
  for (int k = 0; k < 3; ++k) {
    levers_a[k] = cross(point.arm_a, *axes[k]);
    levers_b[k] = cross(point.arm_b, *axes[k]);
  }
  const auto compliance = [&](int i, int k) {
    return (i == k ? a.inverse_mass + b.inverse_mass : 0) + dot(levers_a[i], a.inverse_inertia * levers_a[k]) +
           dot(levers_b[i], b.inverse_inertia * levers_b[k]);
  };
  point.inverse_normal = 1 / compliance(0, 0);
  point.couple_x = compliance(1, 0);
  point.couple_y = compliance(2, 0);
  const double xx = compliance(1, 1), xy = compliance(1, 2), yy = compliance(2, 2), determinant = xx * yy - xy * xy;
  point.xx = yy / determinant;
  point.xy = -xy / determinant;
  point.yy = xx / determinant;
  const double mean = (xx + yy) / 2;
  point.inverse_largest = 1 / (mean + std::sqrt(std::max(0.0, mean * mean - determinant)));
}

std::vector<Motion> motions_of(std::span<const RigidBody> bodies) {
  std::vector<Motion> motions(bodies.size());
  for (std::size_t i = 0; i < bodies.size(); ++i)
    motions[i] = {Triple(bodies[i].velocity),
                  Triple(bodies[i].spin),
                  bodies[i].moves,
                  bodies[i].is_hinged,
                  bodies[i].inverse_mass,
                  Symmetric(bodies[i].inverse_inertia),
                  Triple(),
                  Triple()};
  return motions;
}

RigidRows::RigidRows(std::span<const Motion> motions, std::span<const RigidContact> contacts, const RigidGroup& group,
                     double substep) {
  for (std::size_t i = 0; i < group.contacts.size(); ++i) {
    const RigidContact& contact = contacts[group.contacts[i]];
    const RigidContact* last = i > 0 ? &contacts[group.contacts[i - 1]] : nullptr;
    if (!last || last->a != contact.a || last->b != contact.b || last->normal != contact.normal)
      blocks.push_back(block_of(contact, static_cast<int>(i)));
    blocks.back().end = static_cast<int>(i) + 1;
  }
  std::ranges::stable_sort(blocks, {},
                           [&](const Block& block) { return contacts[group.contacts[block.begin]].fallen; });
  color_blocks(motions);
  points.reserve(group.contacts.size());
  for (Block& block : blocks) {
    const int first = block.begin, count = block.end - first;
    block.begin = static_cast<int>(points.size());
    block.end = block.begin + count;
    for (int i = first; i < first + count; ++i) {
      const int contact = group.contacts[i];
      points.emplace_back().contact = contact;
      prepare(points.back(), block, contacts[contact], motions[block.a], motions[block.b], substep);
    }
  }
}

bool RigidRows::is_cold() const {
  return std::ranges::all_of(points, [](const Point& point) { return point.normal == 0; });
}

/// Each remaining block has a color of its own.
void RigidRows::color_blocks(std::span<const Motion> motions) {
  constexpr int kWorthIt = 128, kColors = 24;
  colors_ = {0};
  if (static_cast<int>(blocks.size()) < kWorthIt) return void(colors_.push_back(static_cast<int>(blocks.size())));
  std::vector<unsigned> used(motions.size(), 0);
  std::vector<int> color_of(blocks.size());
  std::vector<int> counts(kColors + 1, 0);
  for (std::size_t i = 0; i < blocks.size(); ++i) {
    unsigned taken = 0;
    for (const int side : {blocks[i].a, blocks[i].b})
      if (motions[side].moves) taken |= used[side];
    const int color = std::min(std::countr_one(taken), kColors);
    for (const int side : {blocks[i].a, blocks[i].b}) used[side] |= 1u << color;
    color_of[i] = color;
    ++counts[color];
  }
  order_by_color(color_of, counts);
}

void RigidRows::order_by_color(const std::vector<int>& color_of, const std::vector<int>& counts) {
  std::vector<int> next;
  int sum = 0;
  for (std::size_t color = 0; color < counts.size(); ++color) {
    next.push_back(sum);
    sum += counts[color];
    if (counts[color] > 0 && color + 1 < counts.size()) colors_.push_back(sum);
  }
  for (int i = colors_.back(); i < sum; ++i) colors_.push_back(i + 1);
  std::vector<Block> ordered(blocks.size());
  for (std::size_t i = 0; i < blocks.size(); ++i) ordered[next[color_of[i]]++] = blocks[i];
  blocks = std::move(ordered);
}

}  // namespace griffith::contact
