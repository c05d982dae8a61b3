#include "sim/fracture/resistance.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace griffith {

double resistance(const Material& material, bool at_crack_front, double element_size, double strength_factor) {
  if (material.criterion == FractureCriterion::separation_force) return strength_factor * material.separation_toughness;
  const double strength = strength_factor * material.tensile_strength;
  if (!at_crack_front) return strength;
  constexpr double kFrontFactor = 1.3;
  return std::min(strength,
                  kFrontFactor * material.fracture_toughness / std::sqrt(2 * std::numbers::pi * element_size));
}

}  // namespace griffith
