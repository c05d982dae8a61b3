#include "sim/fracture/resistance.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace griffith {

double resistance(const Material& material, double strength_factor) {
  const bool is_force = material.criterion == FractureCriterion::separation_force;
  return strength_factor * (is_force ? material.separation_toughness : material.tensile_strength);
}

double screening_resistance(const Material& material, bool at_crack_front, double element_size,
                            double strength_factor) {
  const double whole = resistance(material, strength_factor);
  if (!at_crack_front || material.criterion == FractureCriterion::separation_force) return whole;
  constexpr double kFrontFactor = 0.65;
  return std::min(whole, kFrontFactor * material.fracture_toughness / std::sqrt(2 * std::numbers::pi * element_size));
}

double fracture_energy(const Material& material, double strength_fraction) {
  const double toughness = strength_fraction * material.fracture_toughness, ratio = material.poisson_ratio;
  return toughness * toughness * (1 - ratio * ratio) / material.young_modulus;
}

double characteristic_length(const Material& material) {
  const double root = material.fracture_toughness / material.tensile_strength;
  return root * root;
}

}  // namespace griffith
