#pragma once

#include <optional>

#include "sim/elasticity/element.h"

namespace griffith {

/// When an element flows, and how far (O'Brien, Bargteil & Hodgins 2002). Norms are Frobenius norms.
struct PlasticLaw {
  double yield_strain = 0;  ///< γ₁: deviatoric elastic strain at the yield strength [-], > 0
  double limit = 0;         ///< γ₂: largest plastic strain [-], >= 0
};

/// The law of a ductile material, nothing for a brittle one. Von Mises' stress is √(3/2)|s| with the deviatoric stress
/// s = 2μ ε′, so that the yield strength σ_y is reached at γ₁ = σ_y / (√6 μ).
std::optional<PlasticLaw> plastic_law(const Material& material);

/// The plastic strain after flow, with ε′ the deviator of the elastic strain ε − ε_p:
///   Δε_p = ε′ (1 − γ₁/|ε′|) where |ε′| > γ₁;   ε_p ← (ε_p + Δε_p) min(1, γ₂/|ε_p + Δε_p|)
/// Traceless if `plastic_strain` is: volume stays. The elastic energy never grows, since both the step towards ε′ and
/// the projection onto the ball |ε_p| <= γ₂ shorten ε′. An inverted element keeps what it has: its strain is no
/// material's.
Mat3 flow(const PlasticLaw& law, const ElementDeformation& deformation, const Mat3& plastic_strain);

}  // namespace griffith
