#include "sim/elasticity/stiffness.h"

#include "sim/elasticity/principal_stress.h"

namespace griffith {
namespace {

/// Adds the terms of Green's model that depend on the deformation: V [ mu (g_i·g_j) B Bᵀ + (g_iᵀ sigma⁺ g_j) I ].
void add_green_terms(const ElasticLaw& law, const RestElement& rest, const ElementState& state, int corner,
                     double factor, StiffnessRow& row) {
  const Mat3 metric = factor * rest.volume * law.mu * state.frame * state.frame.transpose();
  const Vec3 gradient = rest.shape_gradients.col(corner),
             traction = factor * rest.volume * tensile_part(state.stress) * gradient;
  for (int j = 0; j < 4; ++j) {
    const Vec3 other = rest.shape_gradients.col(j);
    const double nearness = gradient.dot(other);
    for (int k = 0; k < 3; ++k) {
      simd::WideQuad& column = row.columns[3 * j + k];
      column += nearness * simd::WideQuad{metric(0, k), metric(1, k), metric(2, k), 0};
      column[k] += traction.dot(other);
    }
  }
}

/// Adds the terms of an element that resists compaction, with b_i = B C g_i: V [ b_i b_jᵀ + ¼ (b_j b_iᵀ + (b_i·b_j) I)
/// ].
void add_compaction(const RestElement& rest, const ElementState& state, int corner, double factor, StiffnessRow& row) {
  const Mat3 gradient = state.frame * state.compaction.full();
  const Vec3 a = factor * rest.volume * gradient * rest.shape_gradients.col(corner);
  for (int j = 0; j < 4; ++j) {
    const Vec3 b = gradient * rest.shape_gradients.col(j);
    const Mat3 block = a * b.transpose() + 0.25 * (b * a.transpose() + a.dot(b) * Mat3::Identity());
    for (int k = 0; k < 3; ++k) row.columns[3 * j + k] += simd::WideQuad{block(0, k), block(1, k), block(2, k), 0};
  }
}

}  // namespace

StiffnessRow stiffness_row(const ElasticLaw& law, const RestElement& rest, const ElementState& state, int corner,
                           double factor) {
  constexpr simd::WideQuad kUnits[3] = {{1, 0, 0, 0}, {0, 1, 0, 0}, {0, 0, 1, 0}};
  const double lambda = factor * rest.volume * law.lambda, mu = factor * rest.volume * law.mu;
  simd::WideQuad gradients[4];  // a_j
  for (int j = 0; j < 4; ++j) {
    const auto g = rest.shape_gradients.col(j);
    gradients[j] = simd::product(state.frame.data(), g[0], g[1], g[2]);
  }
  const bool corotational = law.model == ElementModel::corotational;
  const simd::WideQuad a = gradients[corner], lambda_a = lambda * a, mu_a = mu * a;
  StiffnessRow row;
  for (int j = 0; j < 4; ++j) {
    const simd::WideQuad b = gradients[j], terms = mu_a * b;
    const double metric = corotational ? terms[0] + terms[1] + terms[2] : 0;
    for (int k = 0; k < 3; ++k) row.columns[3 * j + k] = b[k] * lambda_a + mu_a[k] * b + metric * kUnits[k];
  }
  if (state.is_compacted()) add_compaction(rest, state, corner, factor, row);
  if (!corotational) add_green_terms(law, rest, state, corner, factor, row);
  return row;
}

}  // namespace griffith
