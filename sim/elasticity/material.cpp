#include "sim/elasticity/material.h"

#include <cmath>

namespace griffith {

double lame_lambda(const Material& m) {
  return m.young_modulus * m.poisson_ratio / ((1 + m.poisson_ratio) * (1 - 2 * m.poisson_ratio));
}

double shear_modulus(const Material& m) { return m.young_modulus / (2 * (1 + m.poisson_ratio)); }

double bar_wave_speed(const Material& m) { return std::sqrt(m.young_modulus / m.density); }

}  // namespace griffith
