#pragma once

#include <span>
#include <vector>

#include "sim/world/contact/group_builder.h"

namespace griffith {

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

}  // namespace griffith
