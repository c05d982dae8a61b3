#include "sim/contact/rigid_sweeps.h"

#include <algorithm>
#include <cmath>

namespace griffith::contact {
namespace {

/// Largest work of a substep: rows times sweeps, and without remembered impulses.
constexpr int kWork = 1'000, kMaxSweeps = 8, kColdWork = 60'000, kMaxColdSweeps = 200;
/// Points above which a group gets one sweep, in parallel, whose change is not measured.
constexpr int kMostMeasured = kWork;

Triple relative_velocity(const Motion& a, const Motion& b, const Point& point) {
  return a.velocity + cross(a.spin, point.arm_a) - b.velocity - cross(b.spin, point.arm_b);
}

/// Returns the change of the tangential impulse: that which stops the sliding, or the largest one allowed against it.
Triple friction_change(const Block& block, Point& point, const Triple& velocity, double change) {
  const double limit = block.friction * point.normal;
  const double x = dot(block.first, velocity) + change * point.couple_x,
               y = dot(block.second, velocity) + change * point.couple_y;
  double next_x = point.first - (point.xx * x + point.xy * y), next_y = point.second - (point.xy * x + point.yy * y);
  if (next_x * next_x + next_y * next_y > limit * limit) {
    next_x = point.first - point.inverse_largest * x;
    next_y = point.second - point.inverse_largest * y;
    const double length = std::sqrt(next_x * next_x + next_y * next_y);
    if (length > limit) {
      next_x *= limit / length;
      next_y *= limit / length;
    }
  }
  const Triple impulse = (next_x - point.first) * block.first + (next_y - point.second) * block.second;
  point.first = next_x;
  point.second = next_y;
  return impulse;
}

}  // namespace

double RigidSweeps::power_of_impulses() const {
  double sum = 0;
  for (const Block& block : rows_.blocks)
    for (int i = block.begin; i < block.end; ++i) {
      const Point& point = rows_.points[i];
      const Triple velocity = relative_velocity(motions_[block.a], motions_[block.b], point);
      sum += point.normal * dot(block.normal, velocity) + point.first * dot(block.first, velocity) +
             point.second * dot(block.second, velocity);
    }
  return sum;
}

void RigidSweeps::scale_impulses(double share) {
  for (const Block& block : rows_.blocks)
    for (int i = block.begin; i < block.end; ++i) {
      Point& point = rows_.points[i];
      const Triple change = (share - 1) * Triple{point.normal, point.first, point.second};
      push_sides(block, point, change);
      point.normal += change.x, point.first += change.y, point.second += change.z;
    }
}

/// Applies an impulse along the axes of a block to its sides.
void RigidSweeps::push_sides(const Block& block, const Point& point, const Triple& along_axes) {
  const Triple impulse = along_axes.x * block.normal + along_axes.y * block.first + along_axes.z * block.second;
  if (motions_[block.a].moves) motions_[block.a].push(point.arm_a, impulse);
  if (motions_[block.b].moves) motions_[block.b].push(point.arm_b, -impulse);
}

int RigidSweeps::solve(double tolerance, bool is_cold) {
  const int count = static_cast<int>(rows_.points.size());
  const int most =
      is_cold ? std::clamp(kColdWork / count, 1, kMaxColdSweeps) : std::clamp(kWork / count, 1, kMaxSweeps);
  if (most == 1 && count > kMostMeasured) {
    rows_.for_each_block([&](const Block& block) { relax(block); });
    return 1;
  }
  double last_size = 0;
  for (Point& point : rows_.points) point.direction = Triple();
  for (int done = 1;; ++done) {
    for (Point& point : rows_.points) point.before = {point.normal, point.first, point.second};
    last_change_ = sweep();
    if (last_change_ <= tolerance || done == most) return done;
    last_size = extrapolate(last_size);
  }
}

double RigidSweeps::sweep() {
  double change = 0;
  for (const Block& block : rows_.blocks) change = std::max(change, relax(block));
  return change;
}

/// Extrapolates a sweep along the conjugate direction, unless the sweeps do not converge (Silcowitz, Niebe & Erleben
/// 2010). Returns the size of the sweep's change.
double RigidSweeps::extrapolate(double last_size) {
  double size = 0;
  for (const Point& point : rows_.points) {
    const Triple step = Triple{point.normal, point.first, point.second} - point.before;
    size += dot(step, step) / point.inverse_normal;
  }
  const double share = size < last_size ? size / last_size : 0;
  for (const Block& block : rows_.blocks)
    for (int i = block.begin; i < block.end; ++i) {
      Point& point = rows_.points[i];
      const Triple more = share * point.direction;
      point.direction = Triple{point.normal, point.first, point.second} - point.before + more;
      if (dot(more, more) == 0) continue;
      point.normal += more.x, point.first += more.y, point.second += more.z;
      push_sides(block, point, more);
    }
  return size;
}

/// Solves a block's points in sequence for the others' present impulses, so that its sides separate at least at the
/// target and friction stops sliding within its disc. Returns the largest change of a normal velocity.
double RigidSweeps::relax(const Block& block) {
  Motion a = motions_[block.a], b = motions_[block.b];
  double largest = 0;
  for (int i = block.begin; i < block.end; ++i) {
    Point& point = rows_.points[i];
    const Triple velocity = relative_velocity(a, b, point);
    const double along = dot(block.normal, velocity) - point.target;
    if (point.normal == 0 && along >= 0) continue;
    const double next = std::max(0.0, point.normal - point.inverse_normal * along), change = next - point.normal;
    Triple impulse = change * block.normal;
    point.normal = next;
    if (block.friction > 0) impulse += friction_change(block, point, velocity, change);
    a.push(point.arm_a, impulse);
    b.push(point.arm_b, -impulse);
    largest = std::max(largest, std::abs(change) / point.inverse_normal);
  }
  if (a.moves) motions_[block.a].velocity = a.velocity, motions_[block.a].spin = a.spin;
  if (b.moves) motions_[block.b].velocity = b.velocity, motions_[block.b].spin = b.spin;
  return largest;
}

}  // namespace griffith::contact
