#include "sim/solver/direct_solve.h"

#include <Eigen/SparseCholesky>

namespace griffith {
namespace {

/// Returns the lower triangle by components.
Eigen::SparseMatrix<double> lower_triangle(const BlockSparseMatrix& a) {
  std::vector<Eigen::Triplet<double>> entries;
  entries.reserve(9 * a.blocks.size() / 2);
  for (int row = 0; row < a.rows(); ++row)
    for (int k = a.row_starts[row]; k < a.row_starts[row + 1]; ++k)
      for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j)
          if (3 * a.columns[k] + j <= 3 * row + i)
            entries.emplace_back(3 * row + i, 3 * a.columns[k] + j, a.blocks[k](i, j));
  Eigen::SparseMatrix<double> lower(3 * a.rows(), 3 * a.rows());
  lower.setFromTriplets(entries.begin(), entries.end());
  return lower;
}

}  // namespace

bool direct_solve(const BlockSparseMatrix& a, const NodeVectors& b, NodeVectors& x) {
  const Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>, Eigen::Lower> factorization(lower_triangle(a));
  if (factorization.info() != Eigen::Success) return false;
  const Eigen::VectorXd solution = factorization.solve(Eigen::Map<const Eigen::VectorXd>(b.data(), b.size()));
  if (!solution.allFinite()) return false;
  x = Eigen::Map<const NodeVectors>(solution.data(), 3, b.cols());
  return true;
}

}  // namespace griffith
