#include "sim/solver/block_sparse_matrix.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstring>

#include "sim/core/lanes.h"
#include "sim/core/parallel.h"

namespace griffith {
namespace {

simd::WideQuad load(const double* numbers) {
  simd::WideQuad loaded;
  std::memcpy(&loaded, numbers, sizeof loaded);
  return loaded;
}

/// A x in the first three lanes; the fourth counts for nothing.
simd::WideQuad product(const Mat3& a, const double* x) {
  const double* columns = a.data();
  const simd::WideQuad last = load(columns + 5);
  return load(columns) * x[0] + load(columns + 3) * x[1] + __builtin_shufflevector(last, last, 1, 2, 3, 0) * x[2];
}

}  // namespace

int BlockSparseMatrix::slot(int row, int column) const {
  const auto begin = columns.begin() + row_starts[row], end = columns.begin() + row_starts[row + 1];
  const auto found = std::lower_bound(begin, end, column);
  assert(found != end && *found == column);
  return static_cast<int>(found - columns.begin());
}

void multiply(const BlockSparseMatrix& a, const NodeVectors& x, NodeVectors& y) {
  assert(x.cols() == a.rows());
  y.resize(3, a.rows());
  parallel_for(a.rows(), 1024, [&](int begin, int end) {
    for (int row = begin; row < end; ++row) {
      simd::WideQuad sum = {};
      for (int k = a.row_starts[row]; k < a.row_starts[row + 1]; ++k)
        sum += product(a.blocks[k], x.data() + 3 * a.columns[k]);
      y.col(row) = Vec3(sum[0], sum[1], sum[2]);
    }
  });
}

double dot(const NodeVectors& x, const NodeVectors& y) {
  return parallel_sum(static_cast<int>(x.cols()), [&](int begin, int end) {
    return x.middleCols(begin, end - begin).cwiseProduct(y.middleCols(begin, end - begin)).sum();
  });
}

double diagonal_product_norm(const BlockSparseMatrix& a, const NodeVectors& x) {
  double squares = 0;
  for (int row = 0; row < a.rows(); ++row)
    squares += a.blocks[a.slot(row, row)].squaredNorm() * x.col(row).squaredNorm();
  return std::sqrt(squares);
}

}  // namespace griffith
