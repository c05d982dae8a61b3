#pragma once

#include <optional>
#include <string>

#include "sim/elasticity/material.h"

namespace griffith {

/// Lower limit of a scale factor.
enum class ScalingLimit {
  budget,  ///< none: the budget is kept
  least,   ///< smallest permitted factor
  speed,   ///< speed of the impact or spin, which must be small compared with the slowed waves
  strain   ///< strain at which the body breaks, which grows as 1/f
};

/// Substitute for a body's material if its waves need more microsteps than the budget allows. By dynamic similarity a
/// body of E′ = f² E, σ_t′ = f σ_t and K_Ic′ = f K_Ic, at the same density, breaks at the same speed of impact along
/// the same cracks, 1/f times slower.
struct ScaledImpact {
  double factor = 1;            ///< f, 0..1
  double young_modulus = 0;     ///< E′ [Pa]
  double tensile_strength = 0;  ///< σ_t′ [Pa]
  double microsteps = 0;        ///< microsteps that the rest of the step would need
  double affordable = 0;        ///< microsteps within the budget
  int tets = 0;                 ///< tets of all bodies with resolved waves, which share the budget
  ScalingLimit limit = ScalingLimit::budget;

  bool operator==(const ScaledImpact&) const = default;
};

/// Returns the reason in a sentence with numbers: "8,012 tetrahedra would take 4,100 microsteps, the budget leaves
/// 340". If f is larger than the budget requires, the reason for this follows.
std::string reason(const ScaledImpact& impact);

/// Returns Young's modulus and tensile strength as fractions of the material's: "E/256, σ/16".
std::string scale_text(const ScaledImpact& impact);

/// Keeps in `least` the one with the smallest f.
void keep_least(std::optional<ScaledImpact>& least, const std::optional<ScaledImpact>& impact);

}  // namespace griffith
