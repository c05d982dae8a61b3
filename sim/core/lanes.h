#pragma once

// Eight things side by side, such as tetrahedra: one single-precision number of each in a vector register, and the
// transposes between such registers and arrays of nodes. Written with the compiler's vector types, so that it runs
// wherever it compiles.

namespace griffith::simd {

inline constexpr int kLanes = 8;

using Lanes = float __attribute__((vector_size(32)));      ///< one number of each
using Quad = float __attribute__((vector_size(16)));       ///< x, y, z and one more
using WideQuad = double __attribute__((vector_size(32)));  ///< the same in double precision

inline Lanes all(float x) { return Lanes{x, x, x, x, x, x, x, x}; }
inline Lanes at_least(Lanes x, float minimum) { return x > all(minimum) ? x : all(minimum); }
inline Lanes at_most(Lanes x, float maximum) { return x < all(maximum) ? x : all(maximum); }

inline Lanes root(Lanes x) {
  for (int lane = 0; lane < kLanes; ++lane) x[lane] = __builtin_sqrtf(x[lane]);
  return x;
}

/// The x, y and z of eight rows.
inline void transpose(const Quad rows[kLanes], Lanes columns[3]) {
  Lanes pair[4];
  for (int i = 0; i < 4; ++i) pair[i] = __builtin_shufflevector(rows[i], rows[i + 4], 0, 1, 2, 3, 4, 5, 6, 7);
  const Lanes xy_even = __builtin_shufflevector(pair[0], pair[1], 0, 8, 1, 9, 4, 12, 5, 13);
  const Lanes xy_odd = __builtin_shufflevector(pair[2], pair[3], 0, 8, 1, 9, 4, 12, 5, 13);
  const Lanes z_even = __builtin_shufflevector(pair[0], pair[1], 2, 10, 3, 11, 6, 14, 7, 15);
  const Lanes z_odd = __builtin_shufflevector(pair[2], pair[3], 2, 10, 3, 11, 6, 14, 7, 15);
  columns[0] = __builtin_shufflevector(xy_even, xy_odd, 0, 1, 8, 9, 4, 5, 12, 13);
  columns[1] = __builtin_shufflevector(xy_even, xy_odd, 2, 3, 10, 11, 6, 7, 14, 15);
  columns[2] = __builtin_shufflevector(z_even, z_odd, 0, 1, 8, 9, 4, 5, 12, 13);
}

/// Writes x, y, z, w of lane i to out[stride · i].
inline void scatter(Lanes x, Lanes y, Lanes z, Lanes w, Quad* out, int stride) {
  const Lanes xy_low = __builtin_shufflevector(x, y, 0, 8, 1, 9, 4, 12, 5, 13);
  const Lanes xy_high = __builtin_shufflevector(x, y, 2, 10, 3, 11, 6, 14, 7, 15);
  const Lanes zw_low = __builtin_shufflevector(z, w, 0, 8, 1, 9, 4, 12, 5, 13);
  const Lanes zw_high = __builtin_shufflevector(z, w, 2, 10, 3, 11, 6, 14, 7, 15);
  const Lanes rows[4] = {__builtin_shufflevector(xy_low, zw_low, 0, 1, 8, 9, 4, 5, 12, 13),
                         __builtin_shufflevector(xy_low, zw_low, 2, 3, 10, 11, 6, 7, 14, 15),
                         __builtin_shufflevector(xy_high, zw_high, 0, 1, 8, 9, 4, 5, 12, 13),
                         __builtin_shufflevector(xy_high, zw_high, 2, 3, 10, 11, 6, 7, 14, 15)};
  for (int i = 0; i < 4; ++i) {
    out[stride * i] = __builtin_shufflevector(rows[i], rows[i], 0, 1, 2, 3);
    out[stride * (i + 4)] = __builtin_shufflevector(rows[i], rows[i], 4, 5, 6, 7);
  }
}

}  // namespace griffith::simd
