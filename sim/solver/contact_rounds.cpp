#include "sim/solver/contact_rounds.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

#include "sim/solver/contact_cone.h"
#include "sim/solver/contact_softness.h"
#include "sim/solver/linear_solvers.h"
#include "sim/solver/zero_of.h"

namespace griffith {
namespace {

/// Share of the tolerance that Newton's method may leave.
constexpr double kNewtonFraction = 0.3;
/// Share of the change of the rounds at which Newton's method for all of the law failed, below which it is tried again.
constexpr double kRetry = 0.3;

/// One round's convex problem and the rounds about it.
class ContactSolver {
 public:
  ContactSolver(ContactSystem& system, const ContactPhase& phase, const ContactTolerance& tolerance)
      : contacts_(phase.contacts),
        least_impulses_(phase.least_impulses),
        energy_(phase.energy),
        tolerance_(tolerance),
        bodies_(system.bodies),
        motion_(system.motion),
        preconditioner_(system.preconditioner),
        response_(system.response) {
    const auto count = static_cast<Eigen::Index>(contacts_.size());
    round_.y = round_.a_y = Eigen::VectorXd::Zero(bodies_.size());
    round_.u.resize(3, count);
    round_.impulses.resize(3, count);
    round_.lifts.resize(count);
    round_.beyond = Eigen::Matrix3Xd::Zero(3, count);
    round_.violations.assign(contacts_.size(), std::numeric_limits<double>::infinity());
    for (std::size_t i = 0; i < contacts_.size(); ++i) {
      const FrictionContact& contact = contacts_[i];
      round_.u.col(i) = contact.free_velocity;
      round_.impulses.col(i) = contact.impulse;
      const double sliding = contact.free_velocity.tail<2>().norm();
      // What stuck goes on sticking, even where it could lift off as well (Painlevé 1895).
      const bool stuck = sticks(contact.impulse, contact.friction);
      round_.lifts[i] = contact.lift >= 0 ? contact.lift : stuck ? 0 : contact.friction * sliding;
      course_.push_back(softness_of(system.deformable, system.rigid, contact));
      round_.softness.push_back(tolerance.continues ? course_[i].settled : course_[i].first);
      to_change_ =
          contact.hold
              ? std::max(to_change_, (contact.hold->apart + contact.free_velocity).norm() - contact.hold->slack)
              : std::max({to_change_, contact.target_velocity - contact.free_velocity[0], stuck ? sliding : 0});
    }
    round_.outer_change = to_change_;
    if (!phase.start) return;
    round_.y = *phase.start;
    bodies_.multiply(round_.y, round_.a_y);
    round_.u += motion_.of(round_.y);
  }

  ContactSolveReport solve() {
    bool responded = false;
    for (int round = 1;; ++round) {
      const bool is_last = round >= tolerance_.max_rounds;
      const Minimum found = minimize(is_last);
      finish_round();
      if (found == Minimum::none) round_.unconverged = static_cast<int>(contacts_.size());
      if (stiffness_.empty()) break;  // no factors: impulses would grow from round to round, and move nothing
      if (round_.unconverged == 0 && found == Minimum::exact) responded = respond();
      if (responded) break;
      // Impulses away from a round's minimum can be any: contacts are as stiff as their elements.
      const bool is_best = found != Minimum::none && round_.outer_change <= best_.outer_change;
      if (is_best) best_ = round_;
      const bool goes_back = (is_coupled_ || is_last) && !is_best && best_.y.size() > 0;
      if (goes_back) go_back();
      if (is_last) break;
      if (goes_back) linearize();
      if (round_.hardens)
        round_.lifts = round_.found_lifts;
      else
        begin_round();
    }
    if (round_.unconverged > 0) settle_for_impulses();
    if (!responded) respond();
    for (std::size_t i = 0; i < contacts_.size(); ++i) {
      contacts_[i].impulse = round_.impulses.col(i);
      contacts_[i].velocity = round_.u.col(i);
      contacts_[i].lift = round_.found_lifts[i];
    }
    report_.unconverged = round_.unconverged;
    return report_;
  }
  const NodeVectors& change(std::size_t body) const { return response_.change(body); }
  const Eigen::VectorXd& unknowns() const { return round_.y; }

 private:
  double negligible_speed() const { return std::max(tolerance_.relative * to_change_, tolerance_.negligible_speed); }

  /// Errors of the lift close or open gaps a little, which the next step corrects.
  double negligible_lift(double lift) const {
    constexpr double kOfTolerance = 10;
    return std::max(kOfTolerance * tolerance_.relative * std::max(to_change_, lift), tolerance_.negligible_speed);
  }

  ConeProjection project(std::size_t i, const Vec3& u) const {
    Vec3 missing = -u;
    if (const std::optional<Hold>& hold = contacts_[i].hold) {
      const Vec3 asked = hold->given + round_.impulses.col(i) + (missing - hold->apart) / round_.softness[i];
      ConeProjection held = hold_back(asked, hold->slack / round_.softness[i], hold->strength);
      held.impulse -= hold->given;
      return held;
    }
    missing[0] += contacts_[i].target_velocity - round_.lifts[i];
    return project_on_cone(round_.impulses.col(i) + missing / round_.softness[i], contacts_[i].friction,
                           least_impulses_.empty() ? 0 : least_impulses_[i]);
  }

  Eigen::Matrix3Xd impulses_at(const Eigen::Matrix3Xd& u) const {
    Eigen::Matrix3Xd impulses(3, u.cols());
    for (Eigen::Index i = 0; i < u.cols(); ++i) impulses.col(i) = project(i, u.col(i)).impulse;
    return impulses;
  }

  /// State after a round, from which the next one begins.
  struct Round {
    Eigen::VectorXd y, a_y;          ///< changes of velocity and what they take
    Eigen::Matrix3Xd u, beyond;      ///< velocities at the contacts; part of condensed bodies beyond those of y
    Eigen::Matrix3Xd impulses;       ///< found
    Eigen::Matrix3Xd pushes;         ///< impulses that the law adds where contacts move as they did
    Eigen::VectorXd lifts;           ///< assumed friction times sliding speed [m/s]
    Eigen::VectorXd found_lifts;     ///< the same, found
    std::vector<double> softness;    ///< r of the next round [1/kg]
    std::vector<double> violations;  ///< by each contact of its law [m/s]
    /// Largest change of a velocity by the round [m/s].
    double outer_change = std::numeric_limits<double>::infinity();
    int unconverged = 0;   ///< contacts that do not meet their law
    bool hardens = false;  ///< contacts that carry are softer than they have to be
  };

  /// Restores the round that has changed least: Newton's method for all of the law may lead away from it.
  void go_back() {
    round_ = best_;
    near_ = kRetry * round_.outer_change;
    is_coupled_ = false;
  }

  /// Takes over the impulses found, and counts the contacts that do not meet their law yet.
  void finish_round() {
    constexpr double kProgress = 0.25, kStiffening = 0.3;
    round_.pushes = Eigen::Matrix3Xd::Zero(3, round_.u.cols());
    round_.found_lifts.resize(round_.u.cols());
    round_.hardens = false;
    round_.unconverged = 0;
    last_change_ = round_.outer_change;
    round_.outer_change = 0;
    for (std::size_t i = 0; i < contacts_.size(); ++i) {
      const Vec3 impulse = project(i, round_.u.col(i)).impulse, change = impulse - round_.impulses.col(i);
      const double lift = contacts_[i].friction * round_.u.col(i).tail<2>().norm(),
                   violation = round_.softness[i] * change.norm();
      const double lifted = impulse.isZero(0) ? 0 : std::abs(lift - round_.lifts[i]);
      const bool lifts = lifted > negligible_lift(lift);
      round_.outer_change = std::max({round_.outer_change, violation, lifts ? lifted : 0});
      const bool hardens = round_.softness[i] > course_[i].settled;
      round_.hardens = round_.hardens || (hardens && !impulse.isZero(0));
      if (violation > negligible_speed() || lifts || (hardens && !impulse.isZero(0))) ++round_.unconverged;
      round_.impulses.col(i) = impulse;
      round_.found_lifts[i] = lift;
      if (!stiffness_.empty()) round_.pushes.col(i) = round_.softness[i] * stiffness_[i] * change;
      if (hardens)
        round_.softness[i] = std::max(kStiffening * round_.softness[i], course_[i].settled);
      else if (violation > std::max(negligible_speed(), kProgress * round_.violations[i]))
        round_.softness[i] = std::max(kStiffening * round_.softness[i], course_[i].least);
      round_.violations[i] = violation;
    }
  }

  /// Starts a round where the last one's linear problem has its minimum under the new impulses and lifts, so that what
  /// slides goes on sliding. Near the solution lifts are found together with the sliding that they cause (Newton's
  /// method for all of the law); alone they converge slowly, or not at all, where shards rest on their corners.
  void begin_round() {
    constexpr double kNear = 0.1, kContracting = 0.7;
    if (is_coupled_ && round_.outer_change > kContracting * last_change_) near_ = kRetry * last_change_;
    is_coupled_ = round_.outer_change < std::min(near_, kNear * to_change_);
    Eigen::VectorXd d = direction(impulses_on_bodies(round_.pushes));
    const Eigen::Matrix3Xd u = round_.u + motion_.of(d);
    for (std::size_t i = 0; i < contacts_.size(); ++i)
      if (!round_.impulses.col(i).isZero(0)) round_.found_lifts[i] = contacts_[i].friction * u.col(i).tail<2>().norm();
    Eigen::VectorXd more = round_.found_lifts - round_.lifts;
    if (is_coupled_) more = (round_.lifts + coupled_lifts(u, more)).cwiseMax(0) - round_.lifts;
    d += direction(impulses_on_bodies(impulses_of_lifts(more)));
    round_.lifts += more;
    search_along(d);
  }

  /// Impulses that lifts take from contacts which move as they did.
  Eigen::Matrix3Xd impulses_of_lifts(const Eigen::VectorXd& lifts) const {
    Eigen::Matrix3Xd impulses(3, lifts.size());
    for (Eigen::Index i = 0; i < lifts.size(); ++i) impulses.col(i) = -lifts[i] * stiffness_[i].col(0);
    return impulses;
  }

  Eigen::VectorXd impulses_on_bodies(const Eigen::Matrix3Xd& impulses) const {
    Eigen::VectorXd on_bodies = Eigen::VectorXd::Zero(bodies_.size());
    motion_.add_impulses(impulses, on_bodies);
    return on_bodies;
  }

  /// Takes what lifts lack where contacts move as they do; returns what they lack once contacts slide accordingly.
  Eigen::VectorXd coupled_lifts(const Eigen::Matrix3Xd& u, const Eigen::VectorXd& missing) const {
    constexpr double kAccuracy = 0.01;
    constexpr int kMost = 30;
    Eigen::Matrix2Xd slope = Eigen::Matrix2Xd::Zero(2, round_.u.cols());  // of lifts by velocities
    for (Eigen::Index i = 0; i < round_.u.cols(); ++i)
      if (round_.impulses(0, i) > 0 && !sticks(round_.impulses.col(i), contacts_[i].friction))
        slope.col(i) = contacts_[i].friction * u.col(i).tail<2>().normalized();
    const auto multiply = [&](const Eigen::VectorXd& lifts) {
      Eigen::VectorXd change;
      preconditioner_.apply(impulses_on_bodies(impulses_of_lifts(lifts)), change);
      return Eigen::VectorXd(lifts -
                             slope.cwiseProduct(motion_.of(change).bottomRows<2>()).colwise().sum().transpose());
    };
    return gmres(multiply, missing, kAccuracy, kMost);
  }

  /// Lets all rows of the bodies respond. False where contacts then do not move as condensed bodies let them: rounds go
  /// on from where they do.
  bool respond() {
    if (tolerance_.contacts_alone) return true;
    const Eigen::Matrix3Xd beyond = response_.respond(round_.impulses, round_.y, kNewtonFraction * tolerance_.relative,
                                                      tolerance_.max_iterations),
                           change = beyond - round_.beyond;
    round_.beyond = beyond;
    round_.u += change;
    const auto moved = static_cast<int>((change.colwise().norm().array() > negligible_speed()).count());
    round_.unconverged = std::max(round_.unconverged, moved);
    return round_.unconverged == 0;
  }

  /// Ends a solve that did not converge: bodies move as its impulses let them, of which the share remains that leaves
  /// the least energy if the whole would add more than it may.
  void settle_for_impulses() {
    follow_impulses();
    double first = 0, second = 0;  // work of a share s: s first + s² second / 2
    for (std::size_t i = 0; i < contacts_.size(); ++i) {
      const Vec3 impulse = round_.impulses.col(i), free = contacts_[i].free_velocity;
      first += impulse.dot(free) - impulse[0] * std::max(0.0, contacts_[i].target_velocity);
      second += impulse.dot(round_.u.col(i) - free);
    }
    if (!(first + second / 2 > energy_)) return;
    const double share = std::clamp(-first / second, 0.0, 1.0);
    for (std::size_t i = 0; i < contacts_.size(); ++i)
      round_.u.col(i) = contacts_[i].free_velocity + share * (round_.u.col(i) - contacts_[i].free_velocity);
    round_.impulses *= share;
    round_.y *= share;
    round_.a_y *= share;
  }

  /// Sets the changes of velocity to those by the impulses.
  void follow_impulses() {
    constexpr int kMost = 10;
    stiffness_.assign(contacts_.size(), Mat3::Zero());
    if (!preconditioner_.factor(stiffness_)) {
      round_.impulses.setZero();
      round_.y.setZero();
      round_.a_y.setZero();
      return;
    }
    for (int i = 0; i < kMost; ++i) {
      Eigen::VectorXd missing = impulses_on_bodies(round_.impulses) - round_.a_y, a_d;
      if (bodies_.speed_under(missing) <= kNewtonFraction * negligible_speed()) return;
      const Eigen::VectorXd d = direction(std::move(missing));
      bodies_.multiply(d, a_d);
      advance_solution(1, d, a_d, motion_.of(d));
    }
  }

  enum class Minimum { none, rough, exact };
  /// Newton's method for one round.
  Minimum minimize(bool is_last) {
    constexpr double kOfRound = 0.1;  // of what the last round changed: the next one changes as much again
    const double inner = std::max(kNewtonFraction * negligible_speed(), is_last ? 0 : kOfRound * round_.outer_change);
    for (int step = 0; step < tolerance_.max_newton_steps; ++step) {
      if (!linearize()) return Minimum::none;
      Eigen::VectorXd residual = -round_.a_y;
      motion_.add_impulses(impulses_now_, residual);
      const double missing = bodies_.speed_under(residual);
      if (missing <= inner)
        return inner <= kNewtonFraction * negligible_speed() || missing <= negligible_speed() ? Minimum::exact
                                                                                              : Minimum::rough;
      ++report_.newton_steps;
      if (!search_along(direction(std::move(residual)))) return Minimum::none;
    }
    return Minimum::none;
  }

  /// Finds the impulses and their derivatives; false where the matrix has no factors.
  bool linearize() {
    impulses_now_.resize(3, round_.u.cols());
    std::vector<Mat3> stiffness(contacts_.size());
    for (std::size_t i = 0; i < contacts_.size(); ++i) {
      const ConeProjection found = project(i, round_.u.col(i));
      impulses_now_.col(i) = found.impulse;
      stiffness[i] = found.derivative / round_.softness[i];
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
  bool search_along(const Eigen::VectorXd& d) {
    Eigen::VectorXd a_d;
    bodies_.multiply(d, a_d);
    const Eigen::Matrix3Xd moved = motion_.of(d);
    const double first = d.dot(round_.a_y), second = d.dot(a_d);
    const auto slope = [&](double step) {
      return first + step * second - moved.cwiseProduct(impulses_at(round_.u + step * moved)).sum();
    };
    const double step = zero_of(slope);
    if (!(step > 0)) return false;
    advance_solution(step, d, a_d, moved);
    return true;
  }

  void advance_solution(double step, const Eigen::VectorXd& d, const Eigen::VectorXd& a_d,
                        const Eigen::Matrix3Xd& moved) {
    round_.y += step * d;
    round_.a_y += step * a_d;
    round_.u += step * moved;
  }

  static double square(double x) { return x * x; }

  std::span<FrictionContact> contacts_;
  std::span<const double> least_impulses_;
  double energy_;
  ContactTolerance tolerance_;
  const ContactBodies& bodies_;
  const ContactMotion& motion_;
  ContactPreconditioner& preconditioner_;
  ContactResponse& response_;
  Round round_, best_;                   // the present one; the one that has changed least
  std::vector<ContactSoftness> course_;  // r over the rounds
  Eigen::Matrix3Xd impulses_now_;
  std::vector<Mat3> stiffness_;
  double last_change_ = 0;                                 // of velocities, by the round before [m/s]
  bool is_coupled_ = false;                                // lifts of this round are found together with sliding
  double near_ = std::numeric_limits<double>::infinity();  // change below which that is tried [m/s]
  double to_change_ = 0;                                   // largest velocity that contacts have to make [m/s]
  ContactSolveReport report_;
};

}  // namespace

ContactOutcome solve_rounds(ContactSystem& system, const ContactPhase& phase, const ContactTolerance& tolerance) {
  ContactSolver solver(system, phase, tolerance);
  ContactOutcome outcome{solver.solve(), solver.unknowns(), {}};
  if (tolerance.contacts_alone) return outcome;
  for (std::size_t i = 0; i < system.deformable.size(); ++i) outcome.changes.push_back(solver.change(i));
  return outcome;
}

}  // namespace griffith
