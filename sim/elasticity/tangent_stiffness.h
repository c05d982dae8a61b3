#pragma once

#include "sim/elasticity/stiffness.h"

namespace griffith {

/// Second derivative of an element's energy by its deformation gradient F = U Σ Vᵀ, per volume at rest [Pa]. In the
/// frames U and V, D = Uᵀ dF V, it is (Smith, de Goes & Kim 2019; Stomakhin et al. 2012)
///   Σ S_ij D_ii D_jj + Σ_{i<j} ½ [ f_ij (D_ij + D_ji)² + t_ij (D_ij − D_ji)² ]
/// with S = ∂²ψ/∂σ_i∂σ_j, f_ij = (ψ_i − ψ_j)/(σ_i − σ_j) and t_ij = (ψ_i + ψ_j)/(σ_i + σ_j). Unlike stiffness_row(), it
/// includes the buckling of compressed elements and the resistance of stretched ones to rotation.
struct TangentStiffness {
  Mat3 left = Mat3::Identity(), right = Mat3::Identity();  ///< U, V
  Mat3 stretching = Mat3::Zero();                          ///< S
  Vec3 shearing = Vec3::Zero(), turning = Vec3::Zero();    ///< f and t of the pairs (1, 2), (2, 0), (0, 1)

  /// Returns a corner's row of the element's stiffness [N/m], times `factor`; as stiffness_row().
  StiffnessRow row(const RestElement& rest, int corner, double factor) const;
};

/// Returns the tangent stiffness of an element without plastic strain. Raises eigenvalues to at least `least` [Pa], <=
/// 0, so that the matrix of a step remains positive definite.
TangentStiffness tangent_stiffness(const ElasticLaw& law, const RestElement& rest, const Corners& corners,
                                   double least);

}  // namespace griffith
