#include "sim/fracture/resistance.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "sim/fracture/fracture_law.h"

namespace griffith {

double resistance(const Material& material, double strength_factor) {
  return strength_factor * material.*fracture_law(material).resistance;
}

double screening_resistance(const Material& material, bool at_crack_front, double element_size,
                            double strength_factor) {
  const double whole = resistance(material, strength_factor);
  if (!at_crack_front || !fracture_law(material).is_stress()) return whole;
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
