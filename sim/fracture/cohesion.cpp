#include "sim/fracture/cohesion.h"

#include <algorithm>
#include <cmath>

namespace griffith {

double Bond::energy_left() const {
  const double left = 1 - opening / critical;
  return 0.5 * force * critical * left * left;
}

double pull(Bond& bond, double opening, double compliance) {
  const double excess = opening - bond.opening;
  if (excess <= 0) return 0;
  const double stopping = excess / compliance;
  if (stopping <= bond.force * (1 - bond.opening / bond.critical)) return stopping;
  // The mean force of a linear law is that at the middle of the opening.
  const double softening = bond.force / bond.critical;
  const double mean = (bond.force - softening * (bond.opening + 0.5 * excess)) / (1 - 0.5 * softening * compliance);
  const double opened = bond.opening + excess - compliance * mean;
  if (0.5 * softening * compliance < 1 && opened < bond.critical) {
    bond.opening = opened;
    return mean;
  }
  // F (excess − F compliance) = energy left
  const double energy = bond.energy_left(), square = excess * excess - 4 * compliance * energy;
  bond = {};
  return square <= 0 ? 0.5 * stopping : 2 * energy / (excess + std::sqrt(square));
}

}  // namespace griffith
