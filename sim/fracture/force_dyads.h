#pragma once

#include "sim/core/lanes.h"

namespace griffith {

/// Split force [N] in the first three lanes. The fourth lane is meaningless.
struct ForceLanes {
  simd::WideQuad tensile = {}, compressive = {};
};

/// Returns 1/length of each lane; 0 for length 0.
inline simd::DoubleLanes inverse_or_zero(simd::DoubleLanes length) {
  const simd::DoubleLanes zero = {};
  return length > 0.0 ? 1.0 / length : zero;
}

/// Sum of m(f⁺) − m(f⁻) [N], by columns.
struct Dyads {
  simd::WideQuad columns[3] = {};

  /// Adds `factor` times the dyads of two elements, in order, so that 1 and −1 cancel exactly.
  void add(const ForceLanes& first, const ForceLanes& second, double factor) {
    simd::WideQuad a = first.tensile, b = first.compressive, c = second.tensile, d = second.compressive;
    simd::transpose(a, b, c, d);
    const simd::DoubleLanes inverse = inverse_or_zero(simd::root(a * a + b * b + c * c));
    add(first, factor, inverse[0], inverse[1]);
    add(second, factor, inverse[2], inverse[3]);
  }

 private:
  void add(const ForceLanes& forces, double factor, double inverse_tensile, double inverse_compressive) {
    const simd::WideQuad tensile = forces.tensile * inverse_tensile,
                         compressive = forces.compressive * inverse_compressive;
    for (int i = 0; i < 3; ++i)
      columns[i] += factor * (tensile * forces.tensile[i] - compressive * forces.compressive[i]);
  }
};

}  // namespace griffith
