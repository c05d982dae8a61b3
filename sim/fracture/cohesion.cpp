#include "sim/fracture/cohesion.h"

#include <algorithm>
#include <cmath>

namespace griffith {

double Bond::energy_left() const {
  if (!holds()) return 0;
  const double left = 1 - opening / critical;
  return 0.5 * force * critical * left * left;
}

double pull(Bond& bond, double opening, double compliance) {
  const double excess = opening - bond.opening;
  if (excess <= 0) return 0;
  const double stopping = excess / compliance, force = bond.strength();
  if (stopping <= force) return stopping;
  const double opened = bond.opening + excess - compliance * force;
  if (opened < bond.critical) {
    bond.opening = opened;
    return force;
  }
  // Half of F (excess − compliance F) is the energy left: the other half of the force's work was done before.
  const double twice_energy = 2 * bond.energy_left(), square = excess * excess - 4 * compliance * twice_energy;
  bond = {};
  return square <= 0 ? 0.5 * stopping : 2 * twice_energy / (excess + std::sqrt(square));
}

double mean_force(const Bond& bond, double opening) {
  if (opening <= bond.opening) return bond.strength();
  if (opening >= bond.critical) return bond.energy_left() / (opening - bond.opening);
  return bond.force * (1 - 0.5 * (bond.opening + opening) / bond.critical);
}

double open(Bond& bond, double opening) {
  if (!bond.holds() || opening <= bond.opening) return 0;
  const double before = bond.energy_left();
  bond.opening = opening;
  if (opening < bond.critical) return before - bond.energy_left();
  bond = {};
  return before;
}

}  // namespace griffith
