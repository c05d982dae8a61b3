#include "sim/elasticity/quadratic_stiffness.h"

#include "sim/core/tet_edge_corners.h"

namespace griffith {
namespace {

using simd::WideQuad;

/// Adds `factor` times K_ij of the linear element to the columns of a block.
void add_block(const StiffnessRow& of_i, int j, double factor, WideQuad* block) {
  for (int k = 0; k < 3; ++k) block[k] += factor * of_i.columns[3 * j + k];
}

}  // namespace

QuadraticStiffnessRow quadratic_stiffness_row(const ElasticLaw& law, const RestElement& rest, const ElementState& mean,
                                              int row, double factor) {
  QuadraticStiffnessRow result = {};
  if (row < 4) {
    const StiffnessRow linear = stiffness_row(law, rest, mean, row, factor);
    for (int a = 0; a < 4; ++a) add_block(linear, a, 1, result.columns + 3 * a);
    for (int edge = 0; edge < 6; ++edge)
      for (const int end : kTetEdges[edge]) add_block(linear, end, 1, result.columns + 3 * (4 + edge));
    return result;
  }
  const auto [i, j] = kTetEdges[row - 4];
  const StiffnessRow of_i = stiffness_row(law, rest, mean, i, factor), of_j = stiffness_row(law, rest, mean, j, factor);
  for (int a = 0; a < 4; ++a)
    for (const StiffnessRow* of_end : {&of_i, &of_j}) add_block(*of_end, a, 1, result.columns + 3 * a);
  for (int edge = 0; edge < 6; ++edge) {
    const auto [k, l] = kTetEdges[edge];
    WideQuad* block = result.columns + 3 * (4 + edge);
    add_block(of_j, l, 0.8 * (1 + (i == k)), block);
    add_block(of_j, k, 0.8 * (1 + (i == l)), block);
    add_block(of_i, l, 0.8 * (1 + (j == k)), block);
    add_block(of_i, k, 0.8 * (1 + (j == l)), block);
  }
  return result;
}

}  // namespace griffith
