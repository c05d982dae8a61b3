#include "sim/fracture/cohesion.h"

#include <cmath>

namespace griffith {

double Bond::energy_left() const {
  const double elastic = opening > 0 ? opening - now * now / opening : 0;
  return 0.5 * held() * (critical - opening + elastic);
}

double pull(Bond& bond, double apart, double compliance) {
  const double held = bond.held(), excess = apart - bond.opening;
  if (excess <= compliance * held) {
    if (bond.opening == 0) return apart / compliance;
    const double stiffness = held / bond.opening;
    bond.now = apart / (1 + compliance * stiffness);
    return stiffness * bond.now;
  }
  const double opened = apart - compliance * held;
  if (opened < bond.critical) {
    bond.opening = bond.now = opened;
    return held;
  }
  // Half of F (excess − compliance F) is the energy left: the other half of the force's work was done before.
  const double twice_energy = 2 * bond.energy_left(), square = excess * excess - 4 * compliance * twice_energy;
  bond = {};
  return square <= 0 ? 0.5 * excess / compliance : 2 * twice_energy / (excess + std::sqrt(square));
}

}  // namespace griffith
