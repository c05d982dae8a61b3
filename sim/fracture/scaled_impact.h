#pragma once

#include <string>

#include "sim/elasticity/material.h"

namespace griffith {

/// What stands in for a body's material while its waves would take more microsteps than the budget leaves. By dynamic
/// similarity a body of E′ = f² E, σ_t′ = f σ_t and K_Ic′ = f K_Ic, at the same density, breaks at the same speed of
/// impact along the same cracks, 1/f times slower.
struct ScaledImpact {
  double factor = 1;            ///< f, 0..1
  double young_modulus = 0;     ///< E′ [Pa]
  double tensile_strength = 0;  ///< σ_t′ [Pa]
  double microsteps = 0;        ///< that what is left of the step would have taken
  double affordable = 0;        ///< microsteps that the budget leaves
  int tets = 0;                 ///< of all bodies whose waves are resolved: what the budget goes into

  bool operator==(const ScaledImpact&) const = default;
};

/// Why, in a sentence with numbers: "8,012 tetrahedra would take 4,100 microsteps, the budget leaves 340".
std::string reason(const ScaledImpact& impact);

}  // namespace griffith
