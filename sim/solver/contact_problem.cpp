#include "sim/solver/contact_problem.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "sim/solver/contact_cone.h"
#include "sim/solver/contact_motion.h"
#include "sim/solver/contact_preconditioner.h"
#include "sim/solver/contact_response.h"
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
    bool responded = false;
    for (int round = 1;; ++round) {
      const bool is_last = round >= tolerance_.max_rounds;
      const Minimum found = minimize(is_last);
      RoundChanges changes = finish_round();
      if (found == Minimum::none) report_.unconverged = static_cast<int>(contacts_.size());
      if (stiffness_.empty()) break;  // no factors: impulses would grow from round to round, and move nothing
      if (report_.unconverged == 0 && found == Minimum::exact) responded = respond();
      if (responded) break;
      if (outer_change_ <= best_.outer_change) remember(changes);
      const bool goes_back = (is_coupled_ || is_last) && outer_change_ > best_.outer_change;
      if (goes_back) changes = go_back();
      if (is_last) break;
      if (goes_back) linearize();
      if (changes.hardens)
        lifts_ = changes.lifts;
      else
        begin_round(std::move(changes));
    }
    if (report_.unconverged > 0) settle_for_impulses();
    if (!responded) respond();
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

  /// Start of the next round.
  struct RoundChanges {
    Eigen::Matrix3Xd pushes;  ///< impulses that the law adds where contacts move as they did
    Eigen::VectorXd lifts;    ///< found
    bool hardens = false;     ///< contacts that carry are softer than they have to be
  };

  /// State after the round that has changed least: Newton's method for all of the law may lead away from it.
  struct Found {
    Eigen::VectorXd y, a_y, lifts;
    Eigen::Matrix3Xd u, beyond, impulses;
    std::vector<double> softness, violations;
    RoundChanges changes;
    double outer_change = std::numeric_limits<double>::infinity();
    int unconverged = 0;
  };
  void remember(const RoundChanges& changes) {
    best_ = {
        y_, a_y_, lifts_, u_, beyond_, impulses_, softness_, violations_, changes, outer_change_, report_.unconverged};
  }
  /// Restores that state. Returns the changes found there.
  RoundChanges go_back() {
    y_ = best_.y, a_y_ = best_.a_y, lifts_ = best_.lifts, u_ = best_.u, beyond_ = best_.beyond;
    impulses_ = best_.impulses;
    softness_ = best_.softness, violations_ = best_.violations;
    outer_change_ = best_.outer_change;
    report_.unconverged = best_.unconverged;
    near_ = kRetry * outer_change_;
    is_coupled_ = false;
    return best_.changes;
  }

  /// Takes over the impulses found, and counts the contacts that do not meet their law yet.
  RoundChanges finish_round() {
    constexpr double kProgress = 0.25, kStiffening = 0.3;
    RoundChanges changes{Eigen::Matrix3Xd::Zero(3, u_.cols()), Eigen::VectorXd(u_.cols())};
    report_.unconverged = 0;
    last_change_ = outer_change_;
    outer_change_ = 0;
    for (std::size_t i = 0; i < contacts_.size(); ++i) {
      const Vec3 impulse = project(i, u_.col(i)).impulse, change = impulse - impulses_.col(i);
      const double lift = contacts_[i].friction * u_.col(i).tail<2>().norm(), violation = softness_[i] * change.norm();
      const double lifted = impulse.isZero(0) ? 0 : std::abs(lift - lifts_[i]);
      const bool lifts = lifted > negligible_lift(lift);
      outer_change_ = std::max({outer_change_, violation, lifts ? lifted : 0});
      const bool hardens = softness_[i] > course_[i].settled;
      changes.hardens = changes.hardens || (hardens && !impulse.isZero(0));
      if (violation > negligible_speed() || lifts || (hardens && !impulse.isZero(0))) ++report_.unconverged;
      impulses_.col(i) = impulse;
      changes.lifts[i] = lift;
      if (!stiffness_.empty()) changes.pushes.col(i) = softness_[i] * stiffness_[i] * change;
      if (hardens)
        softness_[i] = std::max(kStiffening * softness_[i], course_[i].settled);
      else if (violation > std::max(negligible_speed(), kProgress * violations_[i]))
        softness_[i] = std::max(kStiffening * softness_[i], course_[i].least);
      violations_[i] = violation;
    }
    return changes;
  }

  /// Starts a round where the last one's linear problem has its minimum under the new impulses and lifts, so that what
  /// slides goes on sliding. Near the solution lifts are found together with the sliding that they cause (Newton's
  /// method for all of the law); alone they converge slowly, or not at all, where shards rest on their corners.
  void begin_round(RoundChanges changes) {
    constexpr double kNear = 0.1, kContracting = 0.7;
    if (is_coupled_ && outer_change_ > kContracting * last_change_) near_ = kRetry * last_change_;
    is_coupled_ = outer_change_ < std::min(near_, kNear * to_change_);
    Eigen::VectorXd d = direction(impulses_on_bodies(changes.pushes));
    const Eigen::Matrix3Xd u = u_ + motion_.of(d);
    for (std::size_t i = 0; i < contacts_.size(); ++i)
      if (!impulses_.col(i).isZero(0)) changes.lifts[i] = contacts_[i].friction * u.col(i).tail<2>().norm();
    Eigen::VectorXd more = changes.lifts - lifts_;
    if (is_coupled_) more = (lifts_ + coupled_lifts(u, more)).cwiseMax(0) - lifts_;
    d += direction(impulses_on_bodies(impulses_of_lifts(more)));
    lifts_ += more;
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
    Eigen::Matrix2Xd slope = Eigen::Matrix2Xd::Zero(2, u_.cols());  // of lifts by velocities
    for (Eigen::Index i = 0; i < u_.cols(); ++i)
      if (is_sliding(i)) slope.col(i) = contacts_[i].friction * u.col(i).tail<2>().normalized();
    const auto multiply = [&](const Eigen::VectorXd& lifts) {
      Eigen::VectorXd change;
      preconditioner_.apply(impulses_on_bodies(impulses_of_lifts(lifts)), change);
      return Eigen::VectorXd(lifts -
                             slope.cwiseProduct(motion_.of(change).bottomRows<2>()).colwise().sum().transpose());
    };
    return gmres(multiply, missing, kAccuracy, kMost);
  }

  bool is_sliding(Eigen::Index i) const {
    constexpr double kOfCone = 1 - 1e-6;
    const double friction = contacts_[i].friction;
    return impulses_(0, i) > 0 && impulses_.col(i).tail<2>().norm() > kOfCone * friction * impulses_(0, i);
  }

  /// Lets all rows of the bodies respond. False where contacts then do not move as condensed bodies let them: rounds go
  /// on from where they do.
  bool respond() {
    const Eigen::Matrix3Xd beyond = response_.respond(impulses_, y_), change = beyond - beyond_;
    beyond_ = beyond;
    u_ += change;
    const auto moved = static_cast<int>((change.colwise().norm().array() > negligible_speed()).count());
    report_.unconverged = std::max(report_.unconverged, moved);
    return report_.unconverged == 0;
  }

  /// Ends a solve that did not converge: bodies move as its impulses let them, of which the share remains that leaves
  /// the least energy if the whole would add some.
  void settle_for_impulses() {
    follow_impulses();
    double first = 0, second = 0;  // work of a share s: s first + s² second / 2
    for (std::size_t i = 0; i < contacts_.size(); ++i) {
      const Vec3 impulse = impulses_.col(i), free = contacts_[i].free_velocity;
      first += impulse.dot(free) - impulse[0] * std::max(0.0, contacts_[i].target_velocity);
      second += impulse.dot(u_.col(i) - free);
    }
    if (!(first + second / 2 > 0)) return;
    const double share = std::clamp(-first / second, 0.0, 1.0);
    impulses_ *= share;
    y_ *= share;
    a_y_ *= share;
  }

  /// Sets the changes of velocity to those by the impulses.
  void follow_impulses() {
    constexpr int kMost = 10;
    stiffness_.assign(contacts_.size(), Mat3::Zero());
    if (!preconditioner_.factor(stiffness_)) {
      impulses_.setZero();
      y_.setZero();
      a_y_.setZero();
      return;
    }
    for (int i = 0; i < kMost; ++i) {
      Eigen::VectorXd missing = impulses_on_bodies(impulses_) - a_y_, a_d;
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
    const double inner = std::max(kNewtonFraction * negligible_speed(), is_last ? 0 : kOfRound * outer_change_);
    for (int step = 0; step < tolerance_.max_newton_steps; ++step) {
      if (!linearize()) return Minimum::none;
      Eigen::VectorXd residual = -a_y_;
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
  bool search_along(const Eigen::VectorXd& d) {
    Eigen::VectorXd a_d;
    bodies_.multiply(d, a_d);
    const Eigen::Matrix3Xd moved = motion_.of(d);
    const double first = d.dot(a_y_), second = d.dot(a_d);
    const auto slope = [&](double step) {
      return first + step * second - moved.cwiseProduct(impulses_at(u_ + step * moved)).sum();
    };
    const double step = zero_of(slope);
    if (!(step > 0)) return false;
    advance_solution(step, d, a_d, moved);
    return true;
  }

  void advance_solution(double step, const Eigen::VectorXd& d, const Eigen::VectorXd& a_d,
                        const Eigen::Matrix3Xd& moved) {
    y_ += step * d;
    a_y_ += step * a_d;
    u_ += step * moved;
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
  Eigen::VectorXd lifts_;                // friction times sliding speed, of this round [m/s]
  std::vector<double> softness_;         // r of this round [1/kg]
  std::vector<ContactSoftness> course_;  // r over the rounds
  Found best_;
  Eigen::Matrix3Xd beyond_;         // velocities at contacts that condensed bodies have beyond those of y
  std::vector<double> violations_;  // of the round before [m/s]
  Eigen::Matrix3Xd impulses_now_;
  std::vector<Mat3> stiffness_;
  double outer_change_ = 0, last_change_ = 0;              // of velocities, by the last round and the one before [m/s]
  bool is_coupled_ = false;                                // lifts of this round are found together with sliding
  double near_ = std::numeric_limits<double>::infinity();  // change below which that is tried [m/s]
  double to_change_ = 0;                                   // largest velocity that contacts have to make [m/s]
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
