#include "sim/solver/contact_problem.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "sim/solver/contact_cone.h"
#include "sim/solver/contact_motion.h"
#include "sim/solver/contact_preconditioner.h"
#include "sim/solver/contact_response.h"
#include "sim/solver/contact_softness.h"

namespace griffith {
namespace {

/// Share of the tolerance that Newton's method may leave.
constexpr double kNewtonFraction = 0.3;

/// One round's convex problem and the rounds about it.
class ContactSolver {
 public:
  ContactSolver(std::span<const DeformableInertia> deformable, std::span<const RigidInertia> rigid,
                std::span<FrictionContact> contacts, const ContactTolerance& tolerance)
      : contacts_(contacts),
        tolerance_(tolerance),
        bodies_(deformable, rigid, condense(deformable, contacts)),
        motion_(bodies_, deformable, contacts),
        preconditioner_(bodies_, deformable, rigid, contacts),
        response_(bodies_, motion_, deformable, rigid, contacts, kNewtonFraction * tolerance.relative,
                  tolerance.max_iterations),
        y_(Eigen::VectorXd::Zero(bodies_.size())),
        a_y_(y_),
        u_(3, contacts.size()),
        impulses_(3, contacts.size()),
        lifts_(contacts.size()),
        beyond_(Eigen::Matrix3Xd::Zero(3, static_cast<Eigen::Index>(contacts.size()))) {
    for (std::size_t i = 0; i < contacts.size(); ++i) {
      const FrictionContact& contact = contacts[i];
      u_.col(i) = contact.free_velocity;
      impulses_.col(i) = contact.impulse;
      lifts_[i] = contact.friction * contact.free_velocity.tail<2>().norm();
      course_.push_back(softness_of(deformable, rigid, contact));
      softness_.push_back(course_[i].first);
      to_change_ = std::max(to_change_, contact.target_velocity - contact.free_velocity[0]);
    }
    violations_.assign(contacts.size(), std::numeric_limits<double>::infinity());
    outer_change_ = to_change_;
  }

  ContactSolveReport solve() {
    for (int round = 0; round < tolerance_.max_rounds; ++round) {
      const Minimum found = minimize();
      if (next_round() == 0 && found == Minimum::exact && respond()) break;
      if (found == Minimum::none) report_.unconverged = static_cast<int>(contacts_.size());
    }
    if (report_.unconverged > 0) respond();
    for (std::size_t i = 0; i < contacts_.size(); ++i) contacts_[i].impulse = impulses_.col(i);
    return report_;
  }
  const NodeVectors& change(std::size_t body) const { return response_.change(body); }

 private:
  double negligible_speed() const { return std::max(tolerance_.relative * to_change_, tolerance_.negligible_speed); }

  /// Errors of the lift close or open gaps a little, which the next step corrects.
  double negligible_lift(double lift) const {
    constexpr double kOfTolerance = 10;
    return std::max(kOfTolerance * tolerance_.relative * std::max(to_change_, lift), tolerance_.negligible_speed);
  }

  ConeProjection project(std::size_t i, const Vec3& u) const {
    Vec3 missing = -u;
    missing[0] += contacts_[i].target_velocity - lifts_[i];
    return project_on_cone(impulses_.col(i) + missing / softness_[i], contacts_[i].friction);
  }

  Eigen::Matrix3Xd impulses_at(const Eigen::Matrix3Xd& u) const {
    Eigen::Matrix3Xd impulses(3, u.cols());
    for (Eigen::Index i = 0; i < u.cols(); ++i) impulses.col(i) = project(i, u.col(i)).impulse;
    return impulses;
  }

  /// Takes over the impulses found; returns how many contacts do not meet their law yet.
  int next_round() {
    constexpr double kProgress = 0.25, kStiffening = 0.3;
    report_.unconverged = 0;
    outer_change_ = 0;
    for (std::size_t i = 0; i < contacts_.size(); ++i) {
      const Vec3 impulse = project(i, u_.col(i)).impulse, change = impulse - impulses_.col(i);
      const double lift = contacts_[i].friction * u_.col(i).tail<2>().norm(), violation = softness_[i] * change.norm();
      const double lifted = impulse.isZero(0) ? 0 : std::abs(lift - lifts_[i]);
      const bool lifts = lifted > negligible_lift(lift);
      outer_change_ = std::max({outer_change_, violation, lifts ? lifted : 0});
      const bool hardens = softness_[i] > course_[i].settled;
      if (violation > negligible_speed() || lifts || (hardens && !impulse.isZero(0))) ++report_.unconverged;
      impulses_.col(i) = impulse;
      lifts_[i] = lift;
      if (hardens)
        softness_[i] = std::max(kStiffening * softness_[i], course_[i].settled);
      else if (violation > std::max(negligible_speed(), kProgress * violations_[i]))
        softness_[i] = std::max(kStiffening * softness_[i], course_[i].least);
      violations_[i] = violation;
    }
    return report_.unconverged;
  }

  /// Lets all rows of the bodies respond. False where contacts then do not move as condensed bodies let them: rounds go
  /// on from where they do.
  bool respond() {
    const Eigen::Matrix3Xd beyond = response_.respond(impulses_, y_), change = beyond - beyond_;
    beyond_ = beyond;
    u_ += change;
    report_.unconverged += static_cast<int>((change.colwise().norm().array() > negligible_speed()).count());
    return report_.unconverged == 0;
  }

  enum class Minimum { none, rough, exact };
  /// Newton's method for one round.
  Minimum minimize() {
    constexpr double kOfRound = 0.1;  // of what the last round changed: the next one changes as much again
    const double inner = std::max(kNewtonFraction * negligible_speed(), kOfRound * outer_change_);
    for (int step = 0; step < tolerance_.max_newton_steps; ++step) {
      if (!linearize()) return Minimum::none;
      Eigen::VectorXd residual = -a_y_;
      motion_.add_impulses(impulses_now_, residual);
      const double missing = bodies_.speed_under(residual);
      if (missing <= inner)
        return inner <= kNewtonFraction * negligible_speed() || missing <= negligible_speed() ? Minimum::exact
                                                                                              : Minimum::rough;
      ++report_.newton_steps;
      if (!go_along(direction(residual))) return Minimum::none;
    }
    return Minimum::none;
  }

  /// Finds the impulses and their derivatives; false where the matrix has no factors.
  bool linearize() {
    impulses_now_.resize(3, u_.cols());
    std::vector<Mat3> stiffness(contacts_.size());
    for (std::size_t i = 0; i < contacts_.size(); ++i) {
      const ConeProjection found = project(i, u_.col(i));
      impulses_now_.col(i) = found.impulse;
      stiffness[i] = found.derivative / softness_[i];
    }
    if (stiffness == stiffness_) return true;
    stiffness_ = std::move(stiffness);
    if (preconditioner_.factor(stiffness_)) return true;
    stiffness_.clear();
    return false;
  }

  /// Solves (A + Jᵀ G J) d = residual by conjugate gradients.
  Eigen::VectorXd direction(Eigen::VectorXd residual) {
    constexpr double kForcing = 0.01;  // of the residual's norm: Newton's method corrects the rest
    Eigen::VectorXd z, d = Eigen::VectorXd::Zero(bodies_.size()), a_p;
    preconditioner_.apply(residual, z);
    Eigen::VectorXd p = z;
    double rho = residual.dot(z);
    const double target = square(kForcing) * rho;
    for (int i = 0; i < tolerance_.max_iterations && rho > target; ++i) {
      bodies_.multiply(p, a_p);
      Eigen::Matrix3Xd forces = motion_.of(p);
      for (Eigen::Index k = 0; k < forces.cols(); ++k) forces.col(k) = (stiffness_[k] * forces.col(k)).eval();
      motion_.add_impulses(forces, a_p);
      const double step = rho / p.dot(a_p);
      if (!std::isfinite(step)) break;
      d += step * p;
      residual -= step * a_p;
      preconditioner_.apply(residual, z);
      const double before = rho;
      rho = residual.dot(z);
      p = z + rho / before * p;
      ++report_.iterations;
    }
    return d;
  }

  /// Goes to the minimum along a direction; false where that does not lead down.
  bool go_along(const Eigen::VectorXd& d) {
    Eigen::VectorXd a_d;
    bodies_.multiply(d, a_d);
    const Eigen::Matrix3Xd moved = motion_.of(d);
    const double first = d.dot(a_y_), second = d.dot(a_d);
    const auto slope = [&](double step) {
      return first + step * second - moved.cwiseProduct(impulses_at(u_ + step * moved)).sum();
    };
    const double step = zero_of(slope);
    if (!(step > 0)) return false;
    y_ += step * d;
    a_y_ += step * a_d;
    u_ += step * moved;
    return true;
  }

  /// The zero of a function that grows from below 0, beyond 0; 0 where it does not begin below.
  template <class Slope>
  static double zero_of(const Slope& slope) {
    constexpr double kAccuracy = 0.01, kFarthest = 1e6;
    const double start = slope(0.0);
    if (!(start < 0)) return 0;
    double low = 0, low_slope = start, high = 1, high_slope = slope(high);
    if (std::abs(high_slope) <= kAccuracy * -start) return high;
    while (high_slope < 0) {  // contacts that let go are softer than they were
      low = high, low_slope = high_slope;
      if (high > kFarthest) return high;
      high *= 4, high_slope = slope(high);
    }
    double step = high;
    int side = 0;
    for (int i = 0; i < 40; ++i) {  // regula falsi, kept from getting stuck (Illinois: Dowell & Jarratt 1971)
      step = (low * high_slope - high * low_slope) / (high_slope - low_slope);
      const double here = slope(step);
      if (std::abs(here) <= kAccuracy * -start) break;
      if (here < 0) {
        low = step, low_slope = here;
        if (side < 0) high_slope /= 2;
        side = -1;
      } else {
        high = step, high_slope = here;
        if (side > 0) low_slope /= 2;
        side = 1;
      }
    }
    return step;
  }

  static double square(double x) { return x * x; }

  std::span<FrictionContact> contacts_;
  ContactTolerance tolerance_;
  ContactBodies bodies_;
  ContactMotion motion_;
  ContactPreconditioner preconditioner_;
  ContactResponse response_;
  Eigen::VectorXd y_, a_y_;              // changes of velocity and what they take
  Eigen::Matrix3Xd u_;                   // relative velocities at the contacts
  Eigen::Matrix3Xd impulses_;            // of the round before
  std::vector<double> lifts_;            // friction times sliding speed of the round before [m/s]
  std::vector<double> softness_;         // r of this round [1/kg]
  std::vector<ContactSoftness> course_;  // r over the rounds
  Eigen::Matrix3Xd beyond_;              // velocities at contacts that condensed bodies have beyond those of y
  std::vector<double> violations_;       // of the round before [m/s]
  Eigen::Matrix3Xd impulses_now_;
  std::vector<Mat3> stiffness_;
  double outer_change_ = 0;  // of velocities, by the last round [m/s]
  double to_change_ = 0;     // largest velocity that contacts have to make [m/s]
  ContactSolveReport report_;
};

}  // namespace

ContactSolveReport solve_contact_problem(std::span<const DeformableInertia> deformable,
                                         std::span<const RigidInertia> rigid, std::span<FrictionContact> contacts,
                                         const ContactTolerance& tolerance, std::vector<NodeVectors>& changes) {
  ContactSolver solver(deformable, rigid, contacts, tolerance);
  const ContactSolveReport report = solver.solve();
  changes.clear();
  for (std::size_t i = 0; i < deformable.size(); ++i) changes.push_back(solver.change(i));
  return report;
}

}  // namespace griffith
