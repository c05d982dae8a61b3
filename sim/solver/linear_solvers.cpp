#include "sim/solver/linear_solvers.h"

#include <Eigen/Jacobi>
#include <Eigen/SparseCholesky>
#include <cmath>
#include <vector>

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

Eigen::VectorXd gmres(const std::function<Eigen::VectorXd(const Eigen::VectorXd&)>& multiply, const Eigen::VectorXd& b,
                      double tolerance, int max_iterations) {
  const double scale = b.norm();
  if (scale == 0) return b;
  std::vector<Eigen::VectorXd> basis = {b / scale};
  Eigen::MatrixXd triangle = Eigen::MatrixXd::Zero(max_iterations + 1, max_iterations);
  Eigen::VectorXd left = Eigen::VectorXd::Zero(max_iterations + 1);
  left[0] = scale;
  std::vector<Eigen::JacobiRotation<double>> rotations;
  int size = 0;
  while (size < max_iterations && std::abs(left[size]) > tolerance * scale) {
    Eigen::VectorXd next = multiply(basis[size]);
    auto column = triangle.col(size);
    for (int i = 0; i <= size; ++i) {
      column[i] = next.dot(basis[i]);
      next -= column[i] * basis[i];
    }
    const double length = next.norm();
    if (!std::isfinite(length)) break;
    column[size + 1] = length;
    for (int i = 0; i < size; ++i) column.applyOnTheLeft(i, i + 1, rotations[i].adjoint());
    Eigen::JacobiRotation<double>& rotation = rotations.emplace_back();
    rotation.makeGivens(column[size], column[size + 1], &column[size]);
    column[size + 1] = 0;
    left.applyOnTheLeft(size, size + 1, rotation.adjoint());
    ++size;
    if (!(length > 0)) break;
    basis.push_back(next / length);
  }
  const Eigen::VectorXd shares =
      triangle.topLeftCorner(size, size).triangularView<Eigen::Upper>().solve(left.head(size));
  Eigen::VectorXd x = Eigen::VectorXd::Zero(b.size());
  for (int i = 0; i < size; ++i) x += shares[i] * basis[i];
  return x;
}

}  // namespace griffith
