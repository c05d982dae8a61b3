#pragma once

#include <string>

#include "sim/elasticity/material.h"

namespace griffith {

/// What stands in for a body's material in an impact whose substep is too long to see its stress wave. Implicit Euler
/// smooths the impact's stress by f = 1/√(1 + (c dt/L)²), c = √(E/ρ), L the body's extent: as if the body were of a
/// softer material, E′ = f² E. Held against f σ_t and f K_Ic, it breaks at the speed v = σ_t/(ρc) at which it would
/// break in fine substeps. What strained the body before the impact is held against the full strength. Without an
/// impact, and where substeps are short enough, f = 1.
struct SoftenedImpact {
  double factor = 1;            ///< f, 0..1
  double young_modulus = 0;     ///< E′ [Pa]
  double tensile_strength = 0;  ///< f σ_t [Pa]
  double substep = 0;           ///< dt, the longest that the budget left [s]
  double wanted_substep = 0;    ///< that would resolve the impact [s]
  int substeps = 0;             ///< that the budget left for the rest of the step
  int tets = 0;                 ///< of all that moves elastically: what the budget went into

  bool operator==(const SoftenedImpact&) const = default;
};

/// The factor f of a substep [s] for a body of this wave speed [m/s] and extent [m], relative to that of
/// `wanted_substep`.
double softening_factor(double wave_speed, double extent, double substep, double wanted_substep);

/// Why, in a sentence with numbers: "8,012 tetrahedra leave 1 substep of 8.3 ms; 0.21 ms would resolve the impact".
std::string reason(const SoftenedImpact& impact);

}  // namespace griffith
