#pragma once

#include "sim/elasticity/material.h"
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

/// Returns the volume-averaged stress of the elements around a node, quadratic ones at the node, as Cauchy stress in
/// the world frame [Pa]. Elements that an anchor holds do not count, as in candidate_plane(); zero if all are held.
Mat3 mean_stress(const SeparationInput& input, NodeId node);

/// Returns the load of a node with that candidate plane, to be compared with the tensile strength [Pa], >= 0. It is the
/// plane's stress if the material has no strength surface. Else it is the equivalent_tension() of the mean stress in
/// which the plane's stress takes the place of the largest principal stress; 0 where the surface lies far away, under
/// pressure.
double separation_load(const SeparationInput& input, NodeId node, const Material& material,
                       const CandidatePlane& plane);

}  // namespace griffith
