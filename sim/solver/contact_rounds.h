#pragma once

#include <span>
#include <vector>

#include "sim/solver/contact_problem.h"

namespace griffith {

/// A phase of a contact problem. Bodies do not rebound in it: FrictionContact::rebound is left out.
struct ContactPhase {
  std::span<FrictionContact> contacts;
  std::span<const double> least_impulses = {};  ///< normal impulses that act at least [N·s], >= 0; empty: zeros
  const Eigen::VectorXd* start = nullptr;       ///< solution of nearly the same phase of the system; null: none
  double energy = 0;                            ///< energy that it may add if it does not converge [J], >= 0
};

struct ContactOutcome {
  ContactSolveReport report;
  Eigen::VectorXd unknowns;          ///< changes of velocity, of all bodies in the order of the system
  std::vector<NodeVectors> changes;  ///< change of velocity per deformable body, one column a row [m/s]
};

/// Finds the impulses of a phase, which it writes to its contacts; see solve_contact_problem().
ContactOutcome solve_rounds(ContactSystem& system, const ContactPhase& phase, const ContactTolerance& tolerance);

}  // namespace griffith
