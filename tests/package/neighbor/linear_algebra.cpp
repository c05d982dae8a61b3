// Linear algebra of the kinds that the library does, compiled without its flags.
#include <Eigen/Dense>
#include <Eigen/Sparse>
#include <cstdlib>

namespace {

void require(bool holds) {
  if (!holds) std::abort();
}

void solve_dense() {
  const Eigen::MatrixXd m = Eigen::MatrixXd::Random(30, 30) + 30 * Eigen::MatrixXd::Identity(30, 30);
  const Eigen::VectorXd b = Eigen::VectorXd::LinSpaced(30, 0, 1);
  require((m * m.inverse() - Eigen::MatrixXd::Identity(30, 30)).norm() < 1e-9);
  require((m * Eigen::HouseholderQR<Eigen::MatrixXd>(m).solve(b) - b).norm() < 1e-9);
  Eigen::MatrixXf single = m.cast<float>();
  single.conservativeResize(40, 35);
  require(single.topLeftCorner(30, 30) == m.cast<float>());
}

void solve_sparse() {
  Eigen::SparseMatrix<double> a(50, 50);
  for (int i = 0; i < 50; ++i) a.insert(i, i) = 2 + i;
  const Eigen::SimplicialLLT<Eigen::SparseMatrix<double>> factors(a);
  const Eigen::VectorXd b = Eigen::VectorXd::Ones(50);
  require((a * factors.solve(b) - b).norm() < 1e-9);
}

void decompose_small() {
  const Eigen::Matrix3d m = Eigen::Matrix3d::Random();
  const Eigen::JacobiSVD<Eigen::Matrix3d> svd(m, Eigen::ComputeFullU | Eigen::ComputeFullV);
  require((svd.matrixU() * svd.singularValues().asDiagonal() * svd.matrixV().transpose() - m).norm() < 1e-12);
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> eigen(m + m.transpose());
  require(
      (m + m.transpose() - eigen.eigenvectors() * eigen.eigenvalues().asDiagonal() * eigen.eigenvectors().transpose())
          .norm() < 1e-12);
}

const bool done = (solve_dense(), solve_sparse(), decompose_small(), true);

}  // namespace
