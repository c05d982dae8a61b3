#pragma once

#include <array>

#include "sim/elasticity/stiffness.h"

namespace griffith {

/// Columns of blocks K_i0 .. K_i9 of a quadratic tetrahedron, corners first, then edges. The fourth lane is
/// meaningless.
struct QuadraticStiffnessRow {
  simd::WideQuad columns[30];

  Mat3 block(int j) const { return simd::matrix_of(columns + 3 * j); }
};

/// Returns the row of a corner (0..3) or an edge (4..9) of a quadratic tetrahedron's stiffness for the implicit step
/// [N/m], times `factor`, in the frame and under the stress of `mean`, its mean state. All follows from the linear
/// element's blocks K_ab, with edges ij and kl:
///   K_a,ij = K_ai + K_aj
///   K_ij,kl = ⅘ [ (1+δ_ik) K_jl + (1+δ_il) K_jk + (1+δ_jk) K_il + (1+δ_jl) K_ik ]
QuadraticStiffnessRow quadratic_stiffness_row(const ElasticLaw& law, const RestElement& rest, const ElementState& mean,
                                              int row, double factor = 1);

}  // namespace griffith
