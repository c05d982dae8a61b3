#include "sim/solver/block_sparse_matrix.h"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "sim/core/lanes.h"
#include "sim/core/parallel.h"

namespace griffith {
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
      for (int k = a.row_starts[row]; k < a.row_starts[row + 1]; ++k) {
        const double* of_column = x.data() + 3 * a.columns[k];
        sum += simd::product(a.blocks[k].data(), of_column[0], of_column[1], of_column[2]);
      }
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
