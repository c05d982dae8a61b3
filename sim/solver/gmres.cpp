#include "sim/solver/gmres.h"

#include <Eigen/Jacobi>
#include <cmath>
#include <vector>

namespace griffith {

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
