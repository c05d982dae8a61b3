#pragma once

#include <optional>
#include <string>

#include "sim/elasticity/material.h"

namespace griffith {

/// What keeps a scale factor from being smaller.
enum class ScalingLimit {
  budget,  ///< nothing: the budget is kept
  least,   ///< the least factor in use
  speed,   ///< the impact or spin, which must be slow against the slowed waves
  strain   ///< the strain at which the body breaks, which grows as 1/f
};

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
  ScalingLimit limit = ScalingLimit::budget;

  bool operator==(const ScaledImpact&) const = default;
};

/// Why, in a sentence with numbers: "8,012 tetrahedra would take 4,100 microsteps, the budget leaves 340". Where f is
/// larger than the budget asks, it goes on to say why.
std::string reason(const ScaledImpact& impact);

/// Young's modulus and tensile strength as shares of the material's: "E/256, σ/16".
std::string scale_text(const ScaledImpact& impact);

/// Keeps in `least` the one of the smallest f of those given to it.
void keep_least(std::optional<ScaledImpact>& least, const std::optional<ScaledImpact>& impact);

}  // namespace griffith
