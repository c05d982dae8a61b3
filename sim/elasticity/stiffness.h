#pragma once

#include "sim/core/lanes.h"
#include "sim/elasticity/element.h"

namespace griffith {

/// Columns of blocks K_i0 .. K_i3, one after the other. The fourth lane is meaningless.
struct StiffnessRow {
  simd::WideQuad columns[12];

  /// Returns K_ij.
  Mat3 block(int j) const { return simd::matrix_of(columns + 3 * j); }
};

/// Returns a corner's row of the element's stiffness for the implicit step [N/m], times `factor`, with a_i = B g_i:
///   K_ij = V [ lambda a_i a_jᵀ + mu a_j a_iᵀ + mu (g_i·g_j) B Bᵀ + (g_iᵀ sigma⁺ g_j) I ]
/// The last, geometric term exists only for Green's strain. Its tensile part sigma⁺ keeps the matrix positive
/// semidefinite under compression too, and in pure tension K = −∂f/∂x exactly. The corotational row omits the change of
/// Q, so it is exact at rest. Resistance to compaction adds, with C = Compaction::gradient and b_i = B C g_i,
///   V [ b_i b_jᵀ + ¼ (b_j b_iᵀ + (b_i·b_j) I) ]
StiffnessRow stiffness_row(const ElasticLaw& law, const RestElement& rest, const ElementState& state, int corner,
                           double factor = 1);

}  // namespace griffith
