#pragma once

#include <array>

#include "sim/core/lane_vectors.h"
#include "sim/elasticity/element.h"

namespace griffith {

/// Returns B sigma g_i of a corner [Pa/m] in the first three lanes. The force on the corner is −V times it. The fourth
/// lane is meaningless.
inline simd::WideQuad corner_traction(const RestElement& rest, const ElementState& state, int corner) {
  const auto gradient = rest.shape_gradients.col(corner);
  const auto& [xx, yy, zz, xy, xz, yz] = state.stress;
  const double x = gradient[0], y = gradient[1], z = gradient[2];
  return simd::product(state.frame.data(), xx * x + xy * y + xz * z, xy * x + yy * y + yz * z,
                       xz * x + yz * y + zz * z);
}

/// Vectors at the four corners of an element, one lane each, with the bits of one corner at a time.
using CornerVectors = simd::Vector3<simd::DoubleLanes>;

inline CornerVectors corner_gradients(const RestElement& rest) {
  const double* gradients = rest.shape_gradients.data();
  const simd::WideQuad shifted = simd::load(gradients + 8);  // avoids a read beyond the end
  return simd::side_by_side(simd::load(gradients), simd::load(gradients + 3), simd::load(gradients + 6),
                            __builtin_shufflevector(shifted, shifted, 1, 2, 3, 0));
}

/// Returns m v of each.
inline CornerVectors product(const Mat3& m, const CornerVectors& v) {
  const auto row = [&](int i) { return m(i, 0) * v.x + m(i, 1) * v.y + m(i, 2) * v.z; };
  return {row(0), row(1), row(2)};
}
inline CornerVectors product(const SymmetricMat3& m, const CornerVectors& v) {
  return {m.xx * v.x + m.xy * v.y + m.xz * v.z, m.xy * v.x + m.yy * v.y + m.yz * v.z,
          m.xz * v.x + m.yz * v.y + m.zz * v.z};
}

/// Returns corner_traction() of all corners; `gradients`: their shape gradients.
inline CornerVectors corner_tractions(const ElementState& state, const CornerVectors& gradients) {
  return product(state.frame, product(state.stress, gradients));
}

/// Returns the vectors one by one, each in the first three lanes; the fourth is 0.
inline std::array<simd::WideQuad, 4> one_by_one(const CornerVectors& v) {
  simd::WideQuad a = v.x, b = v.y, c = v.z, d = {};
  simd::transpose(a, b, c, d);
  return {a, b, c, d};
}

}  // namespace griffith
