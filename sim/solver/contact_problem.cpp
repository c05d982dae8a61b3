#include "sim/solver/contact_problem.h"

#include <algorithm>
#include <utility>

#include "sim/solver/contact_rounds.h"

namespace griffith {
namespace {

/// Phase of restitution after one of compression.
struct Restitution {
  std::vector<FrictionContact> contacts;  ///< with the velocities and lifts after compression
  std::vector<double> least_impulses;     ///< share of the impulses of compression that contacts give back [N·s]
  double energy = 0;                      ///< energy that compression took [J]
  double speed = 0;                       ///< largest speed of a rebound [m/s]
};

bool rebounds(const FrictionContact& contact) { return contact.rebound > 0 && contact.impulse[0] > 0; }

Restitution restitution_after(std::span<const FrictionContact> compressed) {
  Restitution next{{compressed.begin(), compressed.end()}, {}};
  for (std::size_t i = 0; i < compressed.size(); ++i) {
    const FrictionContact& before = compressed[i];
    FrictionContact& contact = next.contacts[i];
    const double approach = before.target_velocity - before.free_velocity[0];
    const double share = rebounds(before) && approach > 0 ? before.rebound / approach : 0;
    contact.free_velocity = before.velocity;
    contact.impulse = Vec3(share * before.impulse[0], 0, 0);
    next.least_impulses.push_back(contact.impulse[0]);
    // A bond is no impact: its law ties the impulse of both phases to the opening at their end. It holds what a rebound
    // tears apart with what strength is left, and lets go what a rebound brings together.
    if (contact.hold)
      contact.hold->given = before.impulse;
    else
      next.energy -= before.impulse.dot(before.free_velocity + contact.free_velocity) / 2;
    if (share > 0) next.speed = std::max(next.speed, before.rebound);
  }
  next.energy = std::max(next.energy, 0.0);
  return next;
}

/// Adds what another phase found.
void add(const ContactOutcome& more, std::span<const FrictionContact> contacts, ContactOutcome& outcome,
         std::span<FrictionContact> into) {
  for (std::size_t i = 0; i < outcome.changes.size(); ++i) outcome.changes[i] += more.changes[i];
  for (std::size_t i = 0; i < into.size(); ++i) {
    into[i].given_back = contacts[i].impulse;
    into[i].impulse += contacts[i].impulse;
    into[i].velocity = contacts[i].velocity;
    into[i].lift = contacts[i].lift;
  }
  outcome.report.newton_steps += more.report.newton_steps;
  outcome.report.iterations += more.report.iterations;
  outcome.report.unconverged = std::max(outcome.report.unconverged, more.report.unconverged);
}

}  // namespace

ContactSolveReport solve_contact_problem(ContactSystem& system, std::span<FrictionContact> contacts,
                                         const ContactTolerance& tolerance, std::vector<NodeVectors>& changes) {
  for (FrictionContact& contact : contacts) contact.impulse -= std::exchange(contact.given_back, Vec3::Zero());
  ContactPhase compression{contacts};
  if (tolerance.continues && system.compressed) compression.start = &*system.compressed;
  ContactOutcome outcome = solve_rounds(system, compression, tolerance);
  system.compressed = outcome.unknowns;
  if (std::ranges::any_of(contacts, rebounds)) {
    Restitution next = restitution_after(contacts);
    ContactTolerance same_speeds = tolerance;
    same_speeds.negligible_speed = std::max(tolerance.negligible_speed, tolerance.relative * next.speed);
    const ContactPhase phase{next.contacts, next.least_impulses, nullptr, next.energy};
    add(solve_rounds(system, phase, same_speeds), next.contacts, outcome, contacts);
  }
  changes = std::move(outcome.changes);
  return outcome.report;
}

ContactSolveReport solve_contact_problem(std::span<const DeformableInertia> deformable,
                                         std::span<const RigidInertia> rigid, std::span<FrictionContact> contacts,
                                         const ContactTolerance& tolerance, std::vector<NodeVectors>& changes) {
  ContactSystem system(deformable, rigid, contacts);
  return solve_contact_problem(system, contacts, tolerance, changes);
}

}  // namespace griffith
