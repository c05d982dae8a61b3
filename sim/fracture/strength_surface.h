#pragma once

#include "sim/fracture/separation_tensor.h"

namespace griffith {

/// Returns the uniaxial tension that is as near to failure as a stress under the strength surface of Drucker & Prager
/// (1952) through both uniaxial strengths [Pa], of either sign:
///   σ = ½ (1 − κ) I₁ + ½ √3 (1 + κ) √J₂
///   I₁, J₂  trace of the stress, and second invariant of its deviator
///   κ       `strength_ratio`, tensile over compressive strength, 0..1
/// A uniaxial tension is its own, a uniaxial compression p that of κ p. For κ = 0.04 (glass) an equibiaxial tension
/// counts 1.48 times, a hydrostatic one 1.44 times, a shear stress 0.90 times. Kumar, Bourdin, Francfort & Lopez-Pamies
/// (2020), "Revisiting nucleation in the phase-field approach to brittle fracture", eq. 9.
double equivalent_tension(const Mat3& stress, double strength_ratio);
/// Does the same for a stress with this trace [Pa] and squared Frobenius norm [Pa²].
double equivalent_tension(double trace, double squared_norm, double strength_ratio);

/// Returns the volume-averaged stress of the elements around a node, quadratic ones at the node, as Cauchy stress in
/// the world frame [Pa]. Elements that an anchor holds do not count, as in candidate_plane(); zero if all are held.
Mat3 mean_stress(const SeparationInput& input, NodeId node);

}  // namespace griffith
