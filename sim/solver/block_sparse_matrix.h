#pragma once

#include <span>
#include <vector>

#include "sim/core/linear_algebra.h"

namespace griffith {

/// A vector with three components a node: one column a node.
using NodeVectors = Eigen::Matrix3Xd;

/// A square sparse matrix of 3×3 blocks in compressed rows; columns ascend within a row.
struct BlockSparseMatrix {
  std::vector<int> row_starts = {0};  ///< rows() + 1
  std::vector<int> columns;           ///< per block
  std::vector<Mat3> blocks;

  int rows() const { return static_cast<int>(row_starts.size()) - 1; }
  /// Index into `blocks` of (row, column), which must be in the pattern.
  int slot(int row, int column) const;
};

/// y = A x. Sizes match A; `y` is resized.
void multiply(const BlockSparseMatrix& a, const NodeVectors& x, NodeVectors& y);

/// Returns the sum of the products of all components, in an order that does not depend on the threads.
double dot(const NodeVectors& x, const NodeVectors& y);

/// |D x| with the norms of the diagonal blocks D: the size of the terms that cancel in A x when x is all but rigid, and
/// so the size of 1e16 times its rounding errors.
double diagonal_product_norm(const BlockSparseMatrix& a, const NodeVectors& x);

}  // namespace griffith
