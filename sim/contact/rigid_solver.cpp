#include "sim/contact/rigid_solver.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numeric>

#include "sim/contact/rigid_overlaps.h"
#include "sim/contact/rigid_rows.h"
#include "sim/contact/rigid_sweeps.h"
#include "sim/core/parallel.h"

namespace griffith::contact {
namespace {

constexpr int kSubsteps = 8;
/// Fraction of an overlap, beyond the remaining one, that is removed in a step.
constexpr double kPushedOut = 0.2;
/// Velocity change below which a substep is solved, as a fraction of that by external forces.
constexpr double kResidual = 1e-3;
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
            std::span<RigidContact> contacts, RigidGroup& group, double dt)
      : bodies_(bodies),
        motions_(motions),
        turns_(turns),
        contacts_(contacts),
        group_(group),
        dt_(dt),
        h_(dt / kSubsteps),
        rows_(motions, contacts, group, h_),
        sweeps_(motions, rows_),
        is_cold_(rows_.is_cold()) {
    for (const int i : group_.bodies) acceleration_ = std::max(acceleration_, bodies_[i].acceleration.norm());
  }

  int solve() {
    int sweeps = 0;
    for (int substep = 0; substep < kSubsteps; ++substep) {
      for (const int i : group_.bodies) accelerate(i);
      substep == 0 ? start_from_memory() : start_all(substep * h_);
      sweeps += sweeps_.solve(kResidual * h_ * acceleration_, is_cold_);
      for (const int i : group_.bodies) move(i);
    }
    group_.change = sweeps_.last_change();
    sweeps += rebound();
    push_apart(motions_, rows_, kPushedOut);
    finish();
    return static_cast<int>(rows_.points.size()) * sweeps;
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
    const double before = sweeps_.power_of_impulses();
    start_all(0);
    const double after = sweeps_.power_of_impulses();
    if (before + after <= 0) return;
    const double share = std::clamp(-before / (after - before), 0.0, 1.0);
    sweeps_.scale_impulses(share);
    is_cold_ = share == 0;
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
    // On a ball, a contact stays on the line along its normal through the center.
    const bool carries = a_moves && b_moves && !bodies_[block.a].is_round && !bodies_[block.b].is_round;
    for (int i = block.begin; i < block.end; ++i) {
      Point& point = rows_.points[i];
      const double turned = point.is_mean ? along_tangents(block, point)
                                          : dot(down_a, start_of_a(point)) - dot(down_b, start_of_b(point));
      point.gap = point.distance + time * point.driven + along + turned;
      point.target = -std::max(point.gap, 0.0) / h_;
      if (time > 0) point.total += Triple{point.normal, point.first, point.second};
      if (carries && has_slid(point, apart)) meet(block, point, apart, a, b);
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

  static Triple start_of_a(const Point& point) { return point.arm_a + point.shift; }
  static Triple start_of_b(const Point& point) { return point.arm_b - point.shift; }

  /// Returns how far rotations along tangents open a gap [m].
  double along_tangents(const Block& block, const Point& point) const {
    return dot(cross(block.normal, Triple(bodies_[block.a].rotation)), start_of_a(point)) -
           dot(cross(block.normal, Triple(bodies_[block.b].rotation)), start_of_b(point));
  }

  /// True if two bodies have moved `apart` since a contact was placed, by much of its arms.
  static bool has_slid(const Point& point, const Triple& apart) {
    constexpr double kSlid = 0.01 * 0.01;  // of the square of the shorter arm
    const Triple slid = 0.5 * apart - point.shift;
    return dot(slid, slid) > kSlid * std::min(dot(point.arm_a, point.arm_a), dot(point.arm_b, point.arm_b));
  }

  static Triple along_axes(const Block& block, const Triple& values) {
    return values.x * block.normal + values.y * block.first + values.z * block.second;
  }

  /// Adds the angular impulse by the shift of what has been added to the impulse since the last time.
  static void count_couple(const Block& block, Point& point) {
    point.couple -= cross(point.shift, along_axes(block, point.total - point.counted));
    point.counted = point.total;
  }

  /// Places a contact where two bodies meet that have moved `apart` since the start: half-way between where each of
  /// them has carried it. At two places, the impulses on both would change their angular momentum.
  static void meet(const Block& block, Point& point, const Triple& apart, const Motion& a, const Motion& b) {
    count_couple(block, point);
    const Triple shift = 0.5 * apart, arm_a = start_of_a(point), arm_b = start_of_b(point);
    point.shift = shift;
    set_arms(point, block, arm_a - shift, arm_b + shift, a, b);
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
    for (double change = fastest; done < sweeps && change > kTolerance * fastest; ++done) change = sweeps_.sweep();
    for (Point& point : rows_.points) point.total += Triple{point.normal, point.first, point.second};
    return done;
  }

  /// True if two bodies that no impulse stopped would overlap by their velocities at the end of the step alone: gravity
  /// adds to these up to its end. What parted and comes back arrives in the next step.
  bool comes_back(const Block& block, const Point& point) const {
    const Motion &a = motions_[block.a], &b = motions_[block.b];
    double parting = point.driven;
    if (a.moves) parting += dot(block.normal, a.velocity + cross(a.spin, start_of_a(point)));
    if (b.moves) parting -= dot(block.normal, b.velocity + cross(b.spin, start_of_b(point)));
    return point.distance >= 0 && point.distance + dt_ * parting < 0;
  }

  void finish() {
    for (const Block& block : rows_.blocks)
      for (int i = block.begin; i < block.end; ++i) {
        Point& point = rows_.points[i];
        count_couple(block, point);
        contacts_[point.contact].impulse = along_axes(block, point.total).vector();
        contacts_[point.contact].couple = point.couple.vector();
        contacts_[point.contact].force = along_axes(block, point.force).vector() / h_;
        if (!(point.total.x > 0) && !(point.pushed > 0) && !comes_back(block, point)) continue;
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
  RigidGroup& group_;
  double dt_, h_;
  RigidRows rows_;
  RigidSweeps sweeps_;
  bool is_cold_;
  double acceleration_ = 0;  // the largest by external forces [m/s²]
};

}  // namespace

int solve_rigid(std::span<RigidBody> bodies, std::span<RigidContact> contacts, std::span<RigidGroup> groups,
                double dt) {
  std::vector<Motion> motions = motions_of(bodies);
  std::vector<Turn> turns(bodies.size());
  std::vector<int> work(groups.size());
  parallel_for(static_cast<int>(groups.size()), 1, [&](int begin, int end) {
    for (int i = begin; i < end; ++i) work[i] = GroupStep(bodies, motions, turns, contacts, groups[i], dt).solve();
  });
  return std::accumulate(work.begin(), work.end(), 0);
}

}  // namespace griffith::contact
