#pragma once

// Items such as tetrahedra side by side: one number of each in a vector register, eight in single or four in double
// precision. Also transposes between such registers and arrays of nodes. The compiler's vector types make them
// portable.

#include <cmath>
#include <cstring>

#include "sim/core/linear_algebra.h"

namespace griffith::simd {

inline constexpr int kLanes = 8;

using Lanes = float __attribute__((vector_size(32)));      ///< one number of each item
using Quad = float __attribute__((vector_size(16)));       ///< x, y, z and one more
using WideQuad = double __attribute__((vector_size(32)));  ///< the same in double precision

inline constexpr int kDoubleLanes = 4;
using DoubleLanes = WideQuad;                                ///< one double-precision number of each of four items
using DoubleMask = decltype(DoubleLanes{} < DoubleLanes{});  ///< result of comparisons: all bits of a lane or none

inline Lanes broadcast(float x) { return Lanes{x, x, x, x, x, x, x, x}; }
inline Lanes max(Lanes x, float minimum) { return x > broadcast(minimum) ? x : broadcast(minimum); }
inline Lanes min(Lanes x, float maximum) { return x < broadcast(maximum) ? x : broadcast(maximum); }

inline Lanes root(Lanes x) {
  for (int lane = 0; lane < kLanes; ++lane) x[lane] = __builtin_sqrtf(x[lane]);
  return x;
}

inline DoubleLanes root(DoubleLanes x) {
  for (int lane = 0; lane < kDoubleLanes; ++lane) x[lane] = __builtin_sqrt(x[lane]);
  return x;
}
inline DoubleLanes hypotenuse(DoubleLanes a, DoubleLanes b) {
  for (int lane = 0; lane < kDoubleLanes; ++lane) a[lane] = std::hypot(a[lane], b[lane]);
  return a;
}
inline bool any_of(DoubleMask mask) { return (mask[0] | mask[1] | mask[2] | mask[3]) != 0; }
inline bool all_of(DoubleMask mask) { return (mask[0] & mask[1] & mask[2] & mask[3]) != 0; }

// The same for one number, so that a template can compute one element or four.
inline double root(double x) { return std::sqrt(x); }
inline double hypotenuse(double a, double b) { return std::hypot(a, b); }
inline bool any_of(bool mask) { return mask; }
inline bool all_of(bool mask) { return mask; }
template <class Real>
Real absolute(Real x) {
  return x < 0.0 ? -x : x;
}

/// Loads four doubles from unaligned memory.
inline WideQuad load(const double* numbers) {
  WideQuad loaded;
  std::memcpy(&loaded, numbers, sizeof loaded);
  return loaded;
}

/// Returns column i of a 3×3 matrix, stored by columns, in the first three lanes. The fourth lane is meaningless.
inline WideQuad column(const double* matrix, int i) {
  if (i < 2) return load(matrix + 3 * i);
  const WideQuad shifted = load(matrix + 5);  // avoids a read beyond the end
  return __builtin_shufflevector(shifted, shifted, 1, 2, 3, 0);
}

/// Returns the product of such a matrix and (x, y, z) in the same lanes.
inline WideQuad product(const double* matrix, double x, double y, double z) {
  return column(matrix, 0) * x + column(matrix, 1) * y + column(matrix, 2) * z;
}

/// Returns the 3×3 matrix with these columns in the first three lanes.
inline Mat3 matrix_of(const WideQuad* columns) {
  Mat3 m;
  std::memcpy(m.data(), columns, 4 * sizeof(double));
  std::memcpy(m.data() + 3, columns + 1, 4 * sizeof(double));
  std::memcpy(m.data() + 6, columns + 2, 3 * sizeof(double));
  return m;
}

/// Transposes four numbers of four items to number i of each in register i, or back.
inline void transpose(WideQuad& a, WideQuad& b, WideQuad& c, WideQuad& d) {
  const WideQuad ab_even = __builtin_shufflevector(a, b, 0, 4, 2, 6),
                 ab_odd = __builtin_shufflevector(a, b, 1, 5, 3, 7);
  const WideQuad cd_even = __builtin_shufflevector(c, d, 0, 4, 2, 6),
                 cd_odd = __builtin_shufflevector(c, d, 1, 5, 3, 7);
  a = __builtin_shufflevector(ab_even, cd_even, 0, 1, 4, 5);
  b = __builtin_shufflevector(ab_odd, cd_odd, 0, 1, 4, 5);
  c = __builtin_shufflevector(ab_even, cd_even, 2, 3, 6, 7);
  d = __builtin_shufflevector(ab_odd, cd_odd, 2, 3, 6, 7);
}

/// Returns x, y and z of eight rows.
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
