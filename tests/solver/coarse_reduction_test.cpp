#include "sim/solver/coarse_reduction.h"

#include <gtest/gtest.h>

#include <Eigen/Cholesky>
#include <numeric>

#include "tests/random_values.h"

namespace griffith {
namespace {

using testing::RandomValues;

constexpr int kAggregates = 20;

/// A positive definite matrix that couples each aggregate with the next two.
Eigen::MatrixXd chain(RandomValues& random) {
  Eigen::MatrixXd coupling = Eigen::MatrixXd::Zero(6 * kAggregates, 6 * kAggregates);
  for (int i = 0; i < kAggregates; ++i)
    for (int j = i; j < std::min(i + 2, kAggregates); ++j)
      for (int k = 0; k < 36; ++k) coupling(6 * i + k / 6, 6 * j + k % 6) = random.uniform(-1, 1);
  return coupling * coupling.transpose() + Eigen::MatrixXd::Identity(coupling.rows(), coupling.cols());
}

Eigen::SparseMatrix<double> lower_of(const Eigen::MatrixXd& matrix) {
  return matrix.triangularView<Eigen::Lower>().toDenseMatrix().sparseView(0, 0);
}

Eigen::VectorXd random_vector(RandomValues& random, Eigen::Index size) {
  Eigen::VectorXd values(size);
  for (Eigen::Index i = 0; i < size; ++i) values[i] = random.uniform(-1, 1);
  return values;
}

/// Solves with the reduction after contacts have stiffened the touched aggregates.
Eigen::VectorXd solve_reduced(const CoarseReduction& reduction, const std::vector<int>& touched, double stiffness,
                              const Eigen::VectorXd& residual) {
  Eigen::MatrixXd kept = Eigen::MatrixXd(reduction.matrix()).selfadjointView<Eigen::Lower>();
  for (const int aggregate : touched) {
    const int first = 6 * reduction.slot(aggregate);
    kept.block<6, 6>(first, first) += stiffness * Eigen::Matrix<double, 6, 6>::Identity();
  }
  return reduction.extend(kept.llt().solve(reduction.restrict(residual)), residual);
}

Eigen::VectorXd solve_whole(Eigen::MatrixXd matrix, const std::vector<int>& touched, double stiffness,
                            const Eigen::VectorXd& residual) {
  for (const int aggregate : touched)
    matrix.block<6, 6>(6 * aggregate, 6 * aggregate) += stiffness * Eigen::Matrix<double, 6, 6>::Identity();
  return matrix.llt().solve(residual);
}

TEST(CoarseReduction, SolvesAsTheWholeMatrixWhateverContactsStiffen) {
  RandomValues random(7);
  const Eigen::MatrixXd matrix = chain(random);
  for (const std::vector<int>& touched :
       {std::vector<int>{3}, {0, 1, 19}, {2, 5, 6, 11, 12, 17}, {1, 2, 3, 4, 5, 6, 7}}) {
    const CoarseReduction reduction(lower_of(matrix), touched);
    for (const double stiffness : {0.0, 1.0, 1e6}) {
      const Eigen::VectorXd residual = random_vector(random, matrix.rows());
      const Eigen::VectorXd expected = solve_whole(matrix, touched, stiffness, residual);
      EXPECT_LT((solve_reduced(reduction, touched, stiffness, residual) - expected).norm(), 1e-9 * expected.norm());
    }
  }
}

TEST(CoarseReduction, KeepsAllAggregatesWhereMostAreTouched) {
  RandomValues random(8);
  const Eigen::SparseMatrix<double> coarse = lower_of(chain(random));
  EXPECT_EQ(CoarseReduction(coarse, {4, 9}).kept(), 2);
  std::vector<int> most(kAggregates / 2);
  std::iota(most.begin(), most.end(), 0);
  EXPECT_EQ(CoarseReduction(coarse, most).kept(), kAggregates);
}

}  // namespace
}  // namespace griffith
