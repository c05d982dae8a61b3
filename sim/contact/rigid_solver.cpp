#include "sim/contact/rigid_solver.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numeric>

#include "sim/contact/rigid_rows.h"
#include "sim/core/parallel.h"

namespace griffith::contact {
namespace {

constexpr int kSubsteps = 8;
/// Fraction of an overlap, beyond the remaining one, that is removed in a step; it is less for small ones, so that
/// rocking objects come to rest, and is reached at this multiple of the remaining overlap.
constexpr double kPushedOut = 0.2, kFullyPushed = 4;
constexpr int kPushSweeps = 10;
/// Velocity change below which a substep is solved, as a fraction of that by external forces, and its largest work:
/// rows times sweeps. A group without memory must find all of its impulses.
constexpr double kResidual = 1e-3;
constexpr int kWork = 1'000, kMaxSweeps = 8, kColdWork = 60'000, kMaxColdSweeps = 200;
/// Velocity change below which impacts are solved, as a fraction of the highest velocity, and their largest work.
constexpr double kTolerance = 1e-6;
constexpr int kImpactSweeps = 60, kMinImpactSweeps = 4, kImpactWork = 12'000;

/// Rotation of a body since the start of the step.
struct Turn {
  Quat whole = Quat::Identity();
  Mat3 less_identity = Mat3::Zero();
};

class GroupStep {
 public:
  GroupStep(std::span<RigidBody> bodies, std::span<Motion> motions, std::span<Turn> turns,
            std::span<RigidContact> contacts, const RigidGroup& group, double dt)
      : bodies_(bodies),
        motions_(motions),
        turns_(turns),
        contacts_(contacts),
        group_(group),
        dt_(dt),
        h_(dt / kSubsteps),
        rows_(motions, contacts, group, h_),
        is_cold_(rows_.is_cold()) {
    for (const int i : group_.bodies) acceleration_ = std::max(acceleration_, bodies_[i].acceleration.norm());
  }

  int solve() {
    int sweeps = 0;
    for (int substep = 0; substep < kSubsteps; ++substep) {
      for (const int i : group_.bodies) accelerate(i);
      substep == 0 ? start_from_memory() : start_all(substep * h_);
      sweeps += relax_all();
      for (const int i : group_.bodies) move(i);
    }
    sweeps += rebound();
    push_apart(kPushedOut);
    finish();
    return static_cast<int>(rows_.points.size()) * sweeps;
  }

  /// Moves objects out of overlaps at the start.
  void only_push(double whole_share) {
    for (Point& point : rows_.points) point.gap = point.distance;
    push_apart(whole_share);
    for (const Block& block : rows_.blocks)
      for (const int side : {block.a, block.b}) {
        if (!motions_[side].moves) continue;
        bodies_[side].push = motions_[side].push_velocity.vector();
        bodies_[side].push_rotation = motions_[side].push_spin.vector();
      }
  }

 private:
  // A substep.

  void accelerate(int i) const {
    motions_[i].velocity += h_ * Triple(bodies_[i].acceleration);
    motions_[i].spin += h_ * Triple(bodies_[i].turning);
  }

  /// Applies the remembered impulses; only the share (0..1) of them that leaves the least energy if the whole would add
  /// energy. Forces of an impact must not drive bodies apart: there may be too few sweeps to take them back.
  void start_from_memory() {
    if (is_cold_) return start_all(0);
    const double before = power_of_impulses();
    start_all(0);
    const double after = power_of_impulses();
    if (before + after <= 0) return;
    const double share = std::clamp(-before / (after - before), 0.0, 1.0);
    scale_impulses(share);
    is_cold_ = share == 0;
  }

  /// Returns the derivative of the energy of motion by a common factor of all impulses [J].
  double power_of_impulses() const {
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

  void scale_impulses(double share) {
    for (const Block& block : rows_.blocks)
      for (int i = block.begin; i < block.end; ++i) {
        Point& point = rows_.points[i];
        const Triple change = (share - 1) * Triple{point.normal, point.first, point.second};
        push_sides(block, point, change);
        point.normal += change.x, point.first += change.y, point.second += change.z;
      }
  }

  static Triple relative_velocity(const Motion& a, const Motion& b, const Point& point) {
    return a.velocity + cross(a.spin, point.arm_a) - b.velocity - cross(b.spin, point.arm_b);
  }

  /// Applies an impulse along the axes of a block to its sides.
  void push_sides(const Block& block, const Point& point, const Triple& along_axes) const {
    const Triple impulse = along_axes.x * block.normal + along_axes.y * block.first + along_axes.z * block.second;
    if (motions_[block.a].moves) motions_[block.a].push(point.arm_a, impulse);
    if (motions_[block.b].moves) motions_[block.b].push(point.arm_b, -impulse);
  }

  void start_all(double time) {
    rows_.for_each_block([&](Block& block) { start(block, time); });
  }

  /// Sets the gaps, and applies the impulses of the last substep again, which count toward the step's.
  void start(Block& block, double time) {
    Motion a = motions_[block.a], b = motions_[block.b];
    const bool a_moves = a.moves, b_moves = b.moves;
    Triple apart;
    if (a_moves) apart += Triple(bodies_[block.a].displacement);
    if (b_moves) apart -= Triple(bodies_[block.b].displacement);
    const double along = dot(block.normal, apart);
    const Triple down_a = a_moves ? transposed_times(turns_[block.a].less_identity, block.normal) : Triple(),
                 down_b = b_moves ? transposed_times(turns_[block.b].less_identity, block.normal) : Triple();
    for (int i = block.begin; i < block.end; ++i) {
      Point& point = rows_.points[i];
      point.gap = point.distance + time * point.driven + along + dot(down_a, point.arm_a) - dot(down_b, point.arm_b);
      point.target = -std::max(point.gap, 0.0) / h_;
      if (time > 0) point.total += Triple{point.normal, point.first, point.second};
      if (point.normal == 0) {
        point.first = point.second = 0;
        continue;
      }
      const Triple impulse = point.normal * block.normal + point.first * block.first + point.second * block.second;
      a.push(point.arm_a, impulse);
      b.push(point.arm_b, -impulse);
    }
    if (a_moves) motions_[block.a] = a;
    if (b_moves) motions_[block.b] = b;
  }

  /// Returns the sweeps.
  int relax_all() {
    const int count = static_cast<int>(rows_.points.size());
    const int most =
        is_cold_ ? std::clamp(kColdWork / count, 1, kMaxColdSweeps) : std::clamp(kWork / count, 1, kMaxSweeps);
    if (most == 1) {
      rows_.for_each_block([&](Block& block) { relax(block); });
      return 1;
    }
    double last_size = 0;
    for (Point& point : rows_.points) point.direction = Triple();
    for (int done = 1;; ++done) {
      for (Point& point : rows_.points) point.before = {point.normal, point.first, point.second};
      double change = 0;
      for (Block& block : rows_.blocks) change = std::max(change, relax(block));
      if (done == most || change <= kResidual * h_ * acceleration_) return done;
      last_size = extrapolate(last_size);
    }
  }

  /// Extrapolates a sweep along the conjugate direction, unless the sweeps do not converge (Silcowitz, Niebe & Erleben
  /// 2010). Returns the size of the sweep's change.
  double extrapolate(double last_size) {
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
  double relax(Block& block) {
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

  /// Returns the change of the tangential impulse: that which stops the sliding, or the largest one allowed against it.
  static Triple friction_change(const Block& block, Point& point, const Triple& velocity, double change) {
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

  /// Takes out a share of the overlaps by displacements that let nothing else overlap, beside the true velocities.
  void push_apart(double whole_share) {
    bool any = false;
    for (Block& block : rows_.blocks) {
      for (int i = block.begin; i < block.end; ++i) {
        Point& point = rows_.points[i];
        const double overlap = -point.resting - point.gap;
        const double share = whole_share * std::min(1.0, overlap / (kFullyPushed * point.resting));
        point.target = overlap > 0 ? share * overlap : overlap;
        block.overlaps |= overlap > 0;
      }
      any |= block.overlaps;
    }
    for (int sweep = 0; any && sweep < kPushSweeps; ++sweep)
      rows_.for_each_block([&](Block& block) { push_apart(block); });
  }

  void push_apart(Block& block) {
    Motion &a = motions_[block.a], &b = motions_[block.b];
    if (!block.overlaps && !a.is_pushed_out() && !b.is_pushed_out()) return;
    for (int i = block.begin; i < block.end; ++i) {
      Point& point = rows_.points[i];
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

  void move(int i) const {
    RigidBody& body = bodies_[i];
    const Motion& motion = motions_[i];
    body.displacement += h_ * motion.velocity.vector();
    body.rotation += h_ * motion.spin.vector();
    if (body.is_round) return;
    Quat& turn = turns_[i].whole;
    const Vec3 half = 0.5 * h_ * motion.spin.vector();
    turn.coeffs() += (Quat(0, half.x(), half.y(), half.z()) * turn).coeffs();
    turn.normalize();
    turns_[i].less_identity = turn.toRotationMatrix() - Mat3::Identity();
  }

  // The end of a step.

  /// Returns the separation speed for restitution² of the height of a contact's fall, including the rest of it. In
  /// substeps, a fall with g conserves v²/2 + g y + g dt v/2, v downward.
  double rebound_speed(const Point& point) const {
    const double gain = point.fall, before = point.approach - gain, weight = 2 * gain / dt_;
    // The top of the steps lies up to g dt²/8 above that of the fall.
    const double over = gain * gain / 4, square = point.restitution * point.restitution;
    const double left = square * (before * before + gain * before + weight * std::max(0.0, point.distance)) -
                        weight * std::max(0.0, point.gap) - over;
    return left > 0 ? gain / 2 + std::sqrt(gain * gain / 4 + left) : 0;
  }

  /// Separates contacts after impacts; all others in the group remain. Returns the sweeps.
  int rebound() {
    for (Point& point : rows_.points) {
      point.force = Triple{point.normal, point.first, point.second};
      point.total += point.force;
      point.normal = point.first = point.second = 0;
    }
    start_all(dt_);  // adds nothing to the totals now
    double fastest = 0;
    for (Point& point : rows_.points) {
      if (!(point.restitution > 0) || !(point.total.x > 0)) continue;
      const double speed = rebound_speed(point);
      if (!(speed > 0)) continue;
      point.target = speed;
      fastest = std::max(fastest, point.approach);
    }
    if (fastest == 0) return 0;
    const int sweeps = std::clamp(kImpactWork / static_cast<int>(rows_.points.size()), kMinImpactSweeps, kImpactSweeps);
    int done = 0;
    for (double change = fastest; done < sweeps && change > kTolerance * fastest; ++done) {
      change = 0;
      for (Block& block : rows_.blocks) change = std::max(change, relax(block));
    }
    for (Point& point : rows_.points) point.total += Triple{point.normal, point.first, point.second};
    return done;
  }

  void finish() {
    for (const Block& block : rows_.blocks)
      for (int i = block.begin; i < block.end; ++i) {
        const auto along_axes = [&](const Triple& values) {
          return (values.x * block.normal + values.y * block.first + values.z * block.second).vector();
        };
        const Point& point = rows_.points[i];
        contacts_[point.contact].impulse = along_axes(point.total);
        contacts_[point.contact].force = along_axes(point.force) / h_;
        if (!(point.total.x > 0) && !(point.pushed > 0)) continue;
        for (const int side : {block.a, block.b})
          if (motions_[side].moves) bodies_[side].touched = true;
      }
    for (const int i : group_.bodies) {
      RigidBody& body = bodies_[i];
      body.velocity = motions_[i].velocity.vector();
      body.spin = motions_[i].spin.vector();
      body.push = motions_[i].push_velocity.vector();
      body.push_rotation = motions_[i].push_spin.vector();
      if (body.touched) continue;
      body.displacement = dt_ * body.velocity;  // as what flies alone
      body.rotation = dt_ * body.spin;
    }
  }

  std::span<RigidBody> bodies_;
  std::span<Motion> motions_;
  std::span<Turn> turns_;
  std::span<RigidContact> contacts_;
  const RigidGroup& group_;
  double dt_, h_;
  RigidRows rows_;
  bool is_cold_;
  double acceleration_ = 0;  // the largest by external forces [m/s²]
};

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

}  // namespace

int solve_rigid(std::span<RigidBody> bodies, std::span<RigidContact> contacts, std::span<const RigidGroup> groups,
                double dt) {
  std::vector<Motion> motions = motions_of(bodies);
  std::vector<Turn> turns(bodies.size());
  std::vector<int> work(groups.size());
  parallel_for(static_cast<int>(groups.size()), 1, [&](int begin, int end) {
    for (int i = begin; i < end; ++i) work[i] = GroupStep(bodies, motions, turns, contacts, groups[i], dt).solve();
  });
  return std::accumulate(work.begin(), work.end(), 0);
}

void push_apart(std::span<RigidBody> bodies, std::span<RigidContact> contacts, std::span<const RigidGroup> groups,
                double share) {
  std::vector<Motion> motions = motions_of(bodies);
  parallel_for(static_cast<int>(groups.size()), 1, [&](int begin, int end) {
    for (int i = begin; i < end; ++i) GroupStep(bodies, motions, {}, contacts, groups[i], 1).only_push(share);
  });
}

}  // namespace griffith::contact
