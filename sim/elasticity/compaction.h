#pragma once

#include "sim/elasticity/element.h"

namespace griffith {

/// Resistance of an element to compression to a small fraction of its volume, in addition to its elastic law. Ogden's
/// volumetric energy (1972) with β = 2, below a volume ratio J₀:
///   U(J) = κ/4 (2 ln r + r⁻² − 1),   r = J/J₀ < 1,   J = det F
/// Its pressure grows without limit, so that no impact turns elements inside out. Corotational strain alone resists by
/// a finite force (J₀ = 0.3). Green's resists less and less once it is pressed to s = 1/√3 of its length: its force per
/// area (lambda + 2 mu) (1 − s²) s/2 is largest there (J₀ = 1/√3). Below r = 0.02, U goes on as a parabola, so that an
/// element that is inside out comes back (Stomakhin, Howes, Schroeder & Teran 2012).
struct Compaction {
  Mat3 stress = Mat3::Zero();  ///< as ElementState::stress [Pa]
  Mat3 gradient = Mat3::Zero();  ///< C of its stiffness in stiffness_row(), about B⁻¹ ∂J/∂F times the root of U″ [√Pa]
  double energy_density = 0;  ///< [J/m³]
};

/// Returns the contribution to an element with this strain, in the law's measure; `inverted`: in corotational strain.
Compaction compaction_of(const ElasticLaw& law, const Mat3& strain, bool inverted);

/// True if a law resists the compaction of an element to this volume ratio J.
bool is_compacted_at(const ElasticLaw& law, double volume_ratio);

/// Values of U and its derivatives by J [J/m³].
struct VolumeEnergy {
  double value = 0, slope = 0, curvature = 0;
};
/// Returns U of an element with this volume ratio J, at which its law resists compaction.
VolumeEnergy volume_energy(const ElasticLaw& law, double volume_ratio);

/// Modulus κ of a law with these constants [Pa]: from J₀ on, the element is some times stiffer than at rest.
inline double compaction_modulus(double lambda, double mu) { return 0.25 * (lambda + 2 * mu); }

}  // namespace griffith
