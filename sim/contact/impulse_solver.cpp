#include "sim/contact/impulse_solver.h"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <numeric>

#include "sim/core/parallel.h"
#include "sim/core/rotation.h"
#include "sim/geometry/connected_groups.h"

namespace griffith::contact {
namespace {

/// After so many sweeps over the rows that push, all are looked at again.
constexpr int kSweepsBetweenLooks = 5;

/// What a sweep needs of a row again and again. A row waits for the one before: inverses spare it divisions.
struct PreparedRow {
  bool ready = false;                  ///< most rows of a heap never push and need nothing of this
  Mat3 compliance;                     ///< of both ends along the axes [1/kg]
  double inverse_normal;               ///< of its first element [kg], 0 where nothing moves
  Eigen::Matrix2d inverse_tangential;  ///< of its tangential block
  double inverse_largest;              ///< of that block's largest eigenvalue
};

Vec3 velocity_at(const SolverBody& solver_body, const ContactEnd& end) {
  if (solver_body.elastic) return solver_body.elastic->velocity(end.point);
  return solver_body.velocity + solver_body.angular_velocity.cross(end.arm);
}

void push(SolverBody& solver_body, const ContactEnd& end, const Vec3& impulse) {
  if (solver_body.elastic) {
    solver_body.elastic->push(end.point, impulse);
  } else if (solver_body.inverse_mass > 0) {
    solver_body.velocity += solver_body.inverse_mass * impulse;
    solver_body.angular_velocity += solver_body.inverse_inertia * end.arm.cross(impulse);
  }
}

Mat3 compliance_of(const SolverBody& solver_body, const ContactEnd& end) {
  if (solver_body.compliance) return solver_body.compliance->block(end.point);
  const Mat3 arm = cross_matrix(end.arm);
  return solver_body.inverse_mass * Mat3::Identity() - arm * solver_body.inverse_inertia * arm;
}

PreparedRow prepare(const ContactConstraint& row, std::span<const SolverBody> solver_bodies) {
  PreparedRow prepared;
  prepared.ready = true;
  const Mat3 compliance =
      compliance_of(solver_bodies[row.a.solver_body], row.a) + compliance_of(solver_bodies[row.b.solver_body], row.b);
  prepared.compliance = row.axes.transpose() * compliance * row.axes;
  const Eigen::Matrix2d tangential = prepared.compliance.bottomRightCorner<2, 2>();
  const double mean = tangential.trace() / 2;
  prepared.inverse_largest = 1 / (mean + std::sqrt(std::max(0.0, mean * mean - tangential.determinant())));
  prepared.inverse_normal = prepared.compliance(0, 0) > 0 ? 1 / prepared.compliance(0, 0) : 0;
  prepared.inverse_tangential.setZero();
  if (tangential.determinant() > 0) prepared.inverse_tangential = tangential.inverse();
  return prepared;
}

void apply(const ContactConstraint& row, const Vec3& impulse, std::span<SolverBody> solver_bodies) {
  const Vec3 world = row.axes * impulse;
  push(solver_bodies[row.a.solver_body], row.a, world);
  push(solver_bodies[row.b.solver_body], row.b, -world);
}

/// What stops the sliding, where the limit allows it; else as much as it allows, against the sliding.
Vec2 friction_impulse(const Vec2& impulse, const Vec2& sliding, double limit, const PreparedRow& prepared) {
  const Vec2 stopping = impulse - prepared.inverse_tangential * sliding;
  if (stopping.squaredNorm() <= limit * limit) return stopping;
  const Vec2 opposing = impulse - prepared.inverse_largest * sliding;
  const double length = opposing.norm();
  return length > limit ? Vec2(limit / length * opposing) : opposing;
}

Vec3 relative_velocity(const ContactConstraint& row, std::span<const SolverBody> solver_bodies) {
  return velocity_at(solver_bodies[row.a.solver_body], row.a) - velocity_at(solver_bodies[row.b.solver_body], row.b);
}

/// Solves one row among the others' present impulses, with which its ends have this relative `velocity` (world axes);
/// returns the square of the change of velocity that this made.
double relax(ContactConstraint& row, const Vec3& velocity, const PreparedRow& prepared,
             std::span<SolverBody> solver_bodies) {
  if (prepared.inverse_normal == 0) return 0;
  const Vec3 along_axes = row.axes.transpose() * velocity;
  Vec3 next = row.impulse;
  next[0] = std::max(0.0, row.impulse[0] - prepared.inverse_normal * (along_axes[0] - row.target_velocity));
  if (row.friction > 0) {
    const Vec2 sliding = along_axes.tail<2>() + (next[0] - row.impulse[0]) * prepared.compliance.block<2, 1>(1, 0);
    next.tail<2>() = friction_impulse(row.impulse.tail<2>(), sliding, row.friction * next[0], prepared);
  }
  const Vec3 change = next - row.impulse;
  if (change.isZero(0)) return 0;
  row.impulse = next;
  apply(row, change, solver_bodies);
  return (prepared.compliance * change).squaredNorm();
}

/// The rows of objects that hang together by contacts, in their order.
std::vector<std::vector<int>> groups_of_rows(std::span<const ContactConstraint> constraints,
                                             std::span<const SolverBody> solver_bodies) {
  const auto responds = [&](const ContactEnd& end) {
    return solver_bodies[end.solver_body].compliance || solver_bodies[end.solver_body].inverse_mass > 0;
  };
  std::vector<std::pair<int, int>> touching;
  for (const ContactConstraint& row : constraints)
    if (responds(row.a) && responds(row.b)) touching.emplace_back(row.a.solver_body, row.b.solver_body);
  const std::vector<int> group_of = connected_groups(static_cast<int>(solver_bodies.size()), touching);
  std::vector<int> index_of(solver_bodies.size(), -1);
  std::vector<std::vector<int>> groups;
  for (std::size_t i = 0; i < constraints.size(); ++i) {
    if (!responds(constraints[i].a) && !responds(constraints[i].b)) continue;
    int& index =
        index_of[group_of[responds(constraints[i].a) ? constraints[i].a.solver_body : constraints[i].b.solver_body]];
    if (index < 0) {
      index = static_cast<int>(groups.size());
      groups.emplace_back();
    }
    groups[index].push_back(static_cast<int>(i));
  }
  return groups;
}

/// One group's sweeps. In a heap most rows are near misses: what pushes is swept every time, the rest now and then.
class GroupSolver {
 public:
  GroupSolver(std::span<ContactConstraint> constraints, const std::vector<int>& members,
              std::span<SolverBody> solver_bodies)
      : solver_bodies_(solver_bodies) {
    for (int member : members) {
      const ContactConstraint& row = *rows_.emplace_back(&constraints[member]);
      speed_ = std::max(speed_, row.target_velocity - row.axes.col(0).dot(relative_velocity(row, solver_bodies)));
    }
    for (const ContactConstraint* row : rows_)
      if (!row->impulse.isZero(0)) apply(*row, row->impulse, solver_bodies_);
    prepared_.resize(rows_.size());
    before_.resize(rows_.size());
    direction_.assign(rows_.size(), Vec3::Zero());
  }

  /// Returns how many times a row was solved.
  int solve(const SolverLimits& limits) {
    const int sweeps = std::clamp(limits.work / static_cast<int>(rows_.size()), limits.min_sweeps, limits.max_sweeps);
    bool of_all = true;
    for (int i = 1;; ++i) {
      const bool settled = (of_all ? sweep_all() : sweep_busy()) <= limits.tolerance * speed_;
      if ((settled && of_all) || i >= sweeps) return relaxations_;
      extrapolate();
      of_all = settled || i % kSweepsBetweenLooks == 0;
    }
  }

 private:
  /// Returns the square of the change of velocity.
  double relax_row(int i, const Vec3& velocity) {
    if (!prepared_[i].ready) prepared_[i] = prepare(*rows_[i], solver_bodies_);
    before_[i] = rows_[i]->impulse;
    ++relaxations_;
    return relax(*rows_[i], velocity, prepared_[i], solver_bodies_);
  }

  /// Both return the largest change of velocity.
  double sweep_busy() {
    double change = 0;
    for (int i : busy_) change = std::max(change, relax_row(i, relative_velocity(*rows_[i], solver_bodies_)));
    return std::sqrt(change);
  }

  double sweep_all() {
    double change = 0;
    busy_.clear();
    for (int i = 0; i < static_cast<int>(rows_.size()); ++i) {
      const Vec3 velocity = relative_velocity(*rows_[i], solver_bodies_);
      const bool idle = rows_[i]->impulse.isZero(0) && rows_[i]->axes.col(0).dot(velocity) >= rows_[i]->target_velocity;
      if (idle) {
        direction_[i].setZero();
        continue;
      }
      busy_.push_back(i);
      change = std::max(change, relax_row(i, velocity));
    }
    return std::sqrt(change);
  }

  /// Goes on from a sweep along the conjugate direction, unless the sweeps do not converge.
  void extrapolate() {
    double size = 0;
    for (int i : busy_) {
      const Vec3 step = rows_[i]->impulse - before_[i];
      size += step.dot(prepared_[i].compliance * step);
    }
    const double fraction = size < last_size_ ? size / last_size_ : 0;
    for (int i : busy_) {
      const Vec3 step = rows_[i]->impulse - before_[i], more = fraction * direction_[i];
      direction_[i] = step + more;
      if (more.isZero(0)) continue;
      rows_[i]->impulse += more;
      apply(*rows_[i], more, solver_bodies_);
    }
    last_size_ = size;
  }

  std::span<SolverBody> solver_bodies_;
  std::vector<ContactConstraint*> rows_;
  std::vector<PreparedRow> prepared_;
  std::vector<int> busy_;                 // rows that the last look at all found pushing
  std::vector<Vec3> before_, direction_;  // impulses before the sweep; the last change of impulses
  double speed_ = 0, last_size_ = 0;
  int relaxations_ = 0;
};

}  // namespace

int solve_impulses(std::span<ContactConstraint> constraints, std::span<SolverBody> solver_bodies,
                   const SolverLimits& limits) {
  const std::vector<std::vector<int>> groups = groups_of_rows(constraints, solver_bodies);
  std::vector<int> relaxations(groups.size());
  // Groups share nothing but what no impulse moves.
  parallel_for(static_cast<int>(groups.size()), 1, [&](int begin, int end) {
    for (int i = begin; i < end; ++i) relaxations[i] = GroupSolver(constraints, groups[i], solver_bodies).solve(limits);
  });
  return std::accumulate(relaxations.begin(), relaxations.end(), 0);
}

}  // namespace griffith::contact
