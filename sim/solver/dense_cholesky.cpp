#include "sim/solver/dense_cholesky.h"

#include <algorithm>
#include <cmath>
#include <cstring>

#include "sim/core/lanes.h"
#include "sim/core/parallel.h"

namespace griffith {
namespace {

constexpr int kDepth = 48;  // columns whose product with each other stays in cache

/// Four doubles or one of a column.
simd::WideQuad load_into(simd::WideQuad /*type*/, const double* from) { return simd::load(from); }
double load_into(double /*type*/, const double* from) { return *from; }
template <class Number>
void store(Number value, double* to) {
  std::memcpy(to, &value, sizeof value);
}

/// C −= A Bᵀ for `Count` numbers of each of `Columns` columns of C: one term after the other, however many at a time.
template <class Number, int Count, int Columns>
void subtract_tile(double* c, int c_stride, const double* a, const double* b, int stride, int depth) {
  constexpr int kWidth = sizeof(Number) / sizeof(double);
  Number sums[Columns][Count];
  for (int j = 0; j < Columns; ++j)
    for (int i = 0; i < Count; ++i) sums[j][i] = load_into(Number{}, c + static_cast<long>(j) * c_stride + i * kWidth);
  for (int p = 0; p < depth; ++p, a += stride, b += stride) {
    Number of_a[Count];
    for (int i = 0; i < Count; ++i) of_a[i] = load_into(Number{}, a + i * kWidth);
    for (int j = 0; j < Columns; ++j)
      for (int i = 0; i < Count; ++i) sums[j][i] -= of_a[i] * b[j];
  }
  for (int j = 0; j < Columns; ++j)
    for (int i = 0; i < Count; ++i) store(sums[j][i], c + static_cast<long>(j) * c_stride + i * kWidth);
}

template <int Columns>
void subtract_strip(double* c, int c_stride, const double* a, const double* b, int stride, int rows, int depth) {
  int i = 0;
  for (; i + 8 <= rows; i += 8) subtract_tile<simd::WideQuad, 2, Columns>(c + i, c_stride, a + i, b, stride, depth);
  for (; i + 4 <= rows; i += 4) subtract_tile<simd::WideQuad, 1, Columns>(c + i, c_stride, a + i, b, stride, depth);
  for (; i < rows; ++i) subtract_tile<double, 1, Columns>(c + i, c_stride, a + i, b, stride, depth);
}

/// C −= A Bᵀ for columns [begin, end) of C, from row `begin` on downward; A and B share rows with C.
void subtract_product(const DenseColumns& c, const DenseColumns& a, int begin, int end) {
  for (int p = 0; p < a.columns; p += kDepth) {
    const int depth = std::min(kDepth, a.columns - p);
    int j = begin;
    for (; j + 4 <= end; j += 4)
      subtract_strip<4>(c.column(j) + j, c.stride, a.column(p) + j, a.column(p) + j, a.stride, c.rows - j, depth);
    for (; j < end; ++j)
      subtract_strip<1>(c.column(j) + j, c.stride, a.column(p) + j, a.column(p) + j, a.stride, c.rows - j, depth);
  }
}

/// Factors columns [begin, end) from what earlier columns have left of them.
bool factor_columns(const DenseColumns& panel, int begin, int end) {
  for (int j = begin; j < end; ++j) {
    double* const column = panel.column(j);
    for (int p = begin; p < j; ++p) {
      const double* const other = panel.column(p);
      const double factor = other[j];
      for (int i = j; i < panel.rows; ++i) column[i] -= factor * other[i];
    }
    if (!(column[j] > 0)) return false;
    const double inverse = 1 / std::sqrt(column[j]);
    if (!std::isfinite(inverse)) return false;
    for (int i = j; i < panel.rows; ++i) column[i] *= inverse;
  }
  return true;
}

}  // namespace

bool factor_panel(const DenseColumns& panel) {
  constexpr int kBlock = 24;
  for (int begin = 0; begin < panel.columns; begin += kBlock) {
    const int end = std::min(begin + kBlock, panel.columns);
    subtract_product(panel, {panel.values, panel.rows, begin, panel.stride}, begin, end);
    if (!factor_columns(panel, begin, end)) return false;
  }
  return true;
}

void subtract_square(const DenseColumns& c, const DenseColumns& a) {
  constexpr int kStrips = 32, kWide = 4;
  const int strips = (c.columns + kWide - 1) / kWide;
  parallel_for(strips, kStrips,
               [&](int begin, int end) { subtract_product(c, a, kWide * begin, std::min(kWide * end, c.columns)); });
}

double dot_product(const double* a, const double* b, std::size_t count) {
  simd::WideQuad first{}, second{};
  std::size_t i = 0;
  for (; i + 8 <= count; i += 8) {
    first += simd::load(a + i) * simd::load(b + i);
    second += simd::load(a + i + 4) * simd::load(b + i + 4);
  }
  first += second;
  double sum = (first[0] + first[1]) + (first[2] + first[3]);
  for (; i < count; ++i) sum += a[i] * b[i];
  return sum;
}

}  // namespace griffith
