#pragma once

#include "sim/core/lanes.h"
#include "sim/elasticity/element.h"

namespace griffith {

/// The columns of blocks K_i0 .. K_i3, one after the other; the fourth lane counts for nothing.
struct StiffnessRow {
  simd::WideQuad columns[12];

  /// K_ij.
  Mat3 block(int j) const { return simd::matrix_of(columns + 3 * j); }
};

/// A corner's row of the element's stiffness for the implicit step [N/m], times `factor`, with a_i = B g_i:
///   K_ij = V [ lambda a_i a_jᵀ + mu a_j a_iᵀ + mu (g_i·g_j) B Bᵀ + (g_iᵀ sigma⁺ g_j) I ]
/// The last, geometric term is there for Green's strain alone; its tensile part sigma⁺ keeps the matrix positive
/// semidefinite under compression too, and in pure tension K = −∂f/∂x exactly. The corotational row leaves out the
/// change of Q, so that it is exact at rest.
StiffnessRow stiffness_row(const ElasticLaw& law, const RestElement& rest, const ElementState& state, int corner,
                           double factor = 1);

}  // namespace griffith
