#pragma once

#include <vector>

#include "sim/solver/contact_problem.h"
#include "sim/world/contact/group_builder.h"

/// Bonds of cracks in the contact problem of a step: contacts of a body with itself that pull.
namespace griffith {

/// Adds the bonds of a body, then its tied edges, to the problem of its group, in which it has the index `body`, for a
/// substep of `dt` [s].
void add_bond_rows(const WorldState& world, const TouchedBody& of, int body, double dt, ContactGroup& group);

/// Calls visit(row of the group's problem, touched body, index of its bonded pair).
template <class Visit>
void visit_bonds(const TouchedBodies& touched, const ContactGroup& group, const Visit& visit) {
  std::size_t row = group.contacts.size();
  for (const int i : group.touched) {
    const BondsOfBody& bonds = touched.bodies[i].bonds;
    for (std::size_t k = 0; k < bonds.pairs.size(); ++k) visit(row++, i, k);
    row += bonds.ties.size();
  }
}

/// Solves the problem of a group, again and again as its bonds open. Writes the `changes` of velocity of its deformable
/// bodies, one column a row [m/s].
ContactSolveReport solve_with_bonds(const TouchedBodies& touched, ContactGroup& group,
                                    const ContactTolerance& tolerance, std::vector<NodeVectors>& changes, double dt);

}  // namespace griffith
