#include "sim/fracture/resistance.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace griffith {

double resistance(const Material& material, bool at_crack_front, double element_size) {
  if (material.criterion == FractureCriterion::separation_force) return material.separation_toughness;
  if (!at_crack_front) return material.tensile_strength;
  constexpr double kFrontFactor = 1.3;
  return std::min(material.tensile_strength,
                  kFrontFactor * material.fracture_toughness / std::sqrt(2 * std::numbers::pi * element_size));
}

}  // namespace griffith
