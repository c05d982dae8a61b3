#include "sim/contact/impulse_solver.h"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>

#include "sim/contact/connected_groups.h"
#include "sim/rotation.h"

namespace griffith::contact {
namespace {

/// After so many sweeps over the rows that push, all are looked at again.
constexpr int kSweepsBetweenLooks = 5;

/// What a sweep needs of a row again and again.
struct PreparedRow {
  bool ready = false;                  ///< most rows of a heap never push and need nothing of this
  Mat3 compliance;                     ///< of both ends along the axes [1/kg]
  Eigen::Matrix2d inverse_tangential;  ///< of its tangential block
  double largest_tangential;           ///< eigenvalue of that block
};

Vec3 velocity_at(const SolverBody& responder, const ContactEnd& end) {
  if (responder.elastic) return responder.elastic->velocity(end.point);
  return responder.velocity + responder.angular_velocity.cross(end.arm);
}

void push(SolverBody& responder, const ContactEnd& end, const Vec3& impulse) {
  if (responder.elastic) {
    responder.elastic->push(end.point, impulse);
  } else if (responder.inverse_mass > 0) {
    responder.velocity += responder.inverse_mass * impulse;
    responder.angular_velocity += responder.inverse_inertia * end.arm.cross(impulse);
  }
}

Mat3 compliance_of(const SolverBody& responder, const ContactEnd& end) {
  if (responder.compliance) return responder.compliance->block(end.point);
  const Mat3 arm = cross_matrix(end.arm);
  return responder.inverse_mass * Mat3::Identity() - arm * responder.inverse_inertia * arm;
}

PreparedRow prepare(const ContactConstraint& row, std::span<const SolverBody> responders) {
  PreparedRow prepared;
  prepared.ready = true;
  const Mat3 compliance =
      compliance_of(responders[row.a.responder], row.a) + compliance_of(responders[row.b.responder], row.b);
  prepared.compliance = row.axes.transpose() * compliance * row.axes;
  const Eigen::Matrix2d tangential = prepared.compliance.bottomRightCorner<2, 2>();
  const double mean = tangential.trace() / 2;
  prepared.largest_tangential = mean + std::sqrt(std::max(0.0, mean * mean - tangential.determinant()));
  prepared.inverse_tangential.setZero();
  if (tangential.determinant() > 0) prepared.inverse_tangential = tangential.inverse();
  return prepared;
}

void apply(const ContactConstraint& row, const Vec3& impulse, std::span<SolverBody> responders) {
  const Vec3 world = row.axes * impulse;
  push(responders[row.a.responder], row.a, world);
  push(responders[row.b.responder], row.b, -world);
}

/// What stops the sliding, where the limit allows it; else as much as it allows, against the sliding.
Vec2 friction_impulse(const Vec2& impulse, const Vec2& sliding, double limit, const PreparedRow& prepared) {
  const Vec2 stopping = impulse - prepared.inverse_tangential * sliding;
  if (stopping.squaredNorm() <= limit * limit) return stopping;
  const Vec2 opposing = impulse - sliding / prepared.largest_tangential;
  const double length = opposing.norm();
  return length > limit ? Vec2(limit / length * opposing) : opposing;
}

Vec3 relative_velocity(const ContactConstraint& row, std::span<const SolverBody> responders) {
  return velocity_at(responders[row.a.responder], row.a) - velocity_at(responders[row.b.responder], row.b);
}

/// Solves one row among the others' present impulses, with which its ends have this relative `velocity` (world axes);
/// returns the change of velocity that this made.
double relax(ContactConstraint& row, const Vec3& velocity, const PreparedRow& prepared,
             std::span<SolverBody> responders) {
  const double stiffness = prepared.compliance(0, 0);
  if (!(stiffness > 0)) return 0;
  const Vec3 along_axes = row.axes.transpose() * velocity;
  Vec3 next = row.impulse;
  next[0] = std::max(0.0, row.impulse[0] - (along_axes[0] - row.least_speed) / stiffness);
  if (row.friction > 0) {
    const Vec2 sliding = along_axes.tail<2>() + (next[0] - row.impulse[0]) * prepared.compliance.block<2, 1>(1, 0);
    next.tail<2>() = friction_impulse(row.impulse.tail<2>(), sliding, row.friction * next[0], prepared);
  }
  const Vec3 change = next - row.impulse;
  if (change.isZero(0)) return 0;
  row.impulse = next;
  apply(row, change, responders);
  return (prepared.compliance * change).norm();
}

/// The rows of objects that hang together by contacts, in their order.
std::vector<std::vector<int>> groups_of_rows(std::span<const ContactConstraint> rows,
                                             std::span<const SolverBody> responders) {
  const auto answers = [&](const ContactEnd& end) {
    return responders[end.responder].compliance || responders[end.responder].inverse_mass > 0;
  };
  std::vector<std::pair<int, int>> touching;
  for (const ContactConstraint& row : rows)
    if (answers(row.a) && answers(row.b)) touching.emplace_back(row.a.responder, row.b.responder);
  const std::vector<int> group_of = connected_groups(static_cast<int>(responders.size()), touching);
  std::vector<int> index_of(responders.size(), -1);
  std::vector<std::vector<int>> groups;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    if (!answers(rows[i].a) && !answers(rows[i].b)) continue;
    int& index = index_of[group_of[answers(rows[i].a) ? rows[i].a.responder : rows[i].b.responder]];
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
  GroupSolver(std::span<ContactConstraint> rows, const std::vector<int>& members, std::span<SolverBody> responders)
      : responders_(responders) {
    for (int member : members) {
      const ContactConstraint& row = *rows_.emplace_back(&rows[member]);
      speed_ = std::max(speed_, row.least_speed - row.axes.col(0).dot(relative_velocity(row, responders)));
    }
    for (const ContactConstraint* row : rows_)
      if (!row->impulse.isZero(0)) apply(*row, row->impulse, responders_);
    prepared_.resize(rows_.size());
    before_.resize(rows_.size());
    direction_.assign(rows_.size(), Vec3::Zero());
  }

  /// Returns how many times a row was solved.
  int solve(const SolverLimits& limits) {
    const int sweeps =
        std::clamp(limits.work / static_cast<int>(rows_.size()), limits.least_sweeps, limits.most_sweeps);
    bool of_all = true;
    for (int i = 1;; ++i) {
      const bool settled = (of_all ? sweep_all() : sweep_busy()) <= limits.tolerance * speed_;
      if ((settled && of_all) || i >= sweeps) return relaxations_;
      extrapolate();
      of_all = settled || i % kSweepsBetweenLooks == 0;
    }
  }

 private:
  /// Returns the change of velocity.
  double relax_row(int i, const Vec3& velocity) {
    if (!prepared_[i].ready) prepared_[i] = prepare(*rows_[i], responders_);
    before_[i] = rows_[i]->impulse;
    ++relaxations_;
    return relax(*rows_[i], velocity, prepared_[i], responders_);
  }

  /// Both return the largest change of velocity.
  double sweep_busy() {
    double change = 0;
    for (int i : busy_) change = std::max(change, relax_row(i, relative_velocity(*rows_[i], responders_)));
    return change;
  }

  double sweep_all() {
    double change = 0;
    busy_.clear();
    for (int i = 0; i < static_cast<int>(rows_.size()); ++i) {
      const Vec3 velocity = relative_velocity(*rows_[i], responders_);
      const bool idle = rows_[i]->impulse.isZero(0) && rows_[i]->axes.col(0).dot(velocity) >= rows_[i]->least_speed;
      if (idle) {
        direction_[i].setZero();
        continue;
      }
      busy_.push_back(i);
      change = std::max(change, relax_row(i, velocity));
    }
    return change;
  }

  /// Goes on from a sweep along the conjugate direction, unless the sweeps do not converge.
  void extrapolate() {
    double size = 0;
    for (int i : busy_) {
      const Vec3 step = rows_[i]->impulse - before_[i];
      size += step.dot(prepared_[i].compliance * step);
    }
    const double share = size < last_size_ ? size / last_size_ : 0;
    for (int i : busy_) {
      const Vec3 step = rows_[i]->impulse - before_[i], more = share * direction_[i];
      direction_[i] = step + more;
      if (more.isZero(0)) continue;
      rows_[i]->impulse += more;
      apply(*rows_[i], more, responders_);
    }
    last_size_ = size;
  }

  std::span<SolverBody> responders_;
  std::vector<ContactConstraint*> rows_;
  std::vector<PreparedRow> prepared_;
  std::vector<int> busy_;                 // rows that the last look at all found pushing
  std::vector<Vec3> before_, direction_;  // impulses before the sweep; the last change of impulses
  double speed_ = 0, last_size_ = 0;
  int relaxations_ = 0;
};

}  // namespace

int solve_impulses(std::span<ContactConstraint> rows, std::span<SolverBody> responders, const SolverLimits& limits) {
  int relaxations = 0;
  for (const std::vector<int>& members : groups_of_rows(rows, responders))
    relaxations += GroupSolver(rows, members, responders).solve(limits);
  return relaxations;
}

}  // namespace griffith::contact
