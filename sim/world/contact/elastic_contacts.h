#pragma once

#include "sim/solver/contact_problem.h"
#include "sim/world/contact/touched_body.h"
#include "sim/world/state/world_state.h"

namespace griffith {

/// Objects whose contacts and bonds affect one another, and these.
struct ContactGroup {
  std::vector<int> contacts;  ///< indices into contacts()
  std::vector<int> touched;   ///< indices of the deformable bodies in TouchedBodies
  std::vector<DeformableInertia> deformable;
  std::vector<RigidInertia> rigid;
  std::vector<FrictionContact> problem;   ///< per contact, then per bonded pair and tied edge of the touched bodies
  std::vector<double> target_velocities;  ///< likewise, of bodies that do not turn [m/s]
  int unconverged = 0;                    ///< contacts that do not meet their law
  double tolerance = 0;                   ///< at least this, relative, where it is solved again
};

/// Elastic bodies with their contacts, and the groups in which these were solved.
struct SolvedContacts {
  TouchedBodies touched;
  std::vector<ContactGroup> groups;
};

/// Finds the impulses of a substep of `dt` [s] at the contacts of elastic bodies and of the rigid ones that touch them,
/// each group as one convex problem (sim/solver/contact_problem.h), and writes them into contacts() and
/// TouchedBody::bond_impulses. Bonds soften as they open: some problems, one after the other. Leaves what they
/// change in the velocities of the elastic bodies in TouchedBody::change, as found by the solver; counts contacts
/// that do not meet their law.
/// What is quasi-static takes part as a rigid body and deforms under the impulses that it got.
/// Groups with the problem of one of `earlier`, of the same substep, take its solution. Returns the groups.
std::vector<ContactGroup> solve_elastic_contacts(WorldState& world, TouchedBodies& touched, double dt,
                                                 const SolvedContacts& earlier = {});

/// Solves some groups again, from the impulses found before: their bodies would have other velocities without contacts,
/// the present ones, or resist otherwise.
void solve_again(WorldState& world, TouchedBodies& touched, std::span<ContactGroup* const> groups, double dt);

/// Returns the inertia of a body against velocity changes in a substep of `dt` [s].
DeformableInertia deformable_inertia(const WorldState& world, const Body& body, double dt,
                                     bool factors_with_contacts = false);

/// Returns the motions of a body as a whole within its supports, for the present positions of its nodes, in a substep
/// of `dt` [s].
WholeMotion whole_motion(const WorldState& world, const Body& body, double dt);

}  // namespace griffith
