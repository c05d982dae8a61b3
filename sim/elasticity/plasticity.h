#pragma once

#include <optional>

#include "sim/elasticity/element.h"

namespace griffith {

/// Yield criterion and flow of an element (O'Brien, Bargteil & Hodgins 2002). Norms are Frobenius norms.
struct PlasticLaw {
  double yield_strain = 0;  ///< γ₁: deviatoric elastic strain at the yield strength [-], > 0
  double limit = 0;         ///< γ₂: largest plastic strain [-], >= 0
};

/// Returns the law of a ductile material; none for a brittle one. The von Mises stress is √(3/2)|s| with the deviatoric
/// stress s = 2μ ε′, so the yield strength σ_y is reached at γ₁ = σ_y / (√6 μ).
std::optional<PlasticLaw> plastic_law(const Material& material);

/// Returns the plastic strain after flow, with the deviator ε′ of the elastic strain ε − ε_p:
///   Δε_p = ε′ (1 − γ₁/|ε′|) where |ε′| > γ₁;   ε_p ← (ε_p + Δε_p) min(1, γ₂/|ε_p + Δε_p|)
/// It is traceless if `plastic_strain` is, so the volume is kept. The elastic energy never grows, since both the step
/// toward ε′ and the projection onto the ball |ε_p| <= γ₂ shorten ε′. An inverted element keeps its plastic strain,
/// since its strain is unphysical.
Mat3 flow(const PlasticLaw& law, const ElementDeformation& deformation, const Mat3& plastic_strain);

/// Returns the work of a plastic strain Δε_p at the yield strength, 2μ γ₁ |Δε_p| [J/m³].
double yield_work(const PlasticLaw& law, double shear_modulus, const Mat3& flowed);

}  // namespace griffith
