#include "sim/solver/block_triangle.h"

#include <gtest/gtest.h>

#include <Eigen/SparseCholesky>
#include <algorithm>
#include <numeric>

#include "sim/solver/aggregates.h"
#include "tests/random_values.h"

namespace griffith {
namespace {

constexpr int kSize = BlockTriangle::kSize;
using Cholesky = Eigen::SimplicialLLT<Eigen::SparseMatrix<double>, Eigen::Lower, Eigen::NaturalOrdering<int>>;

/// Returns the matrix of a randomly numbered grid of blocks, each coupled to its neighbors, with random values.
Eigen::SparseMatrix<double> grid_matrix(int side, const std::vector<int>& numbers, testing::RandomValues& random) {
  std::vector<Eigen::Triplet<double>> entries;
  const auto join = [&](int a, int b, double diagonal) {
    for (int i = 0; i < kSize; ++i)
      for (int j = 0; j < (a == b ? i + 1 : kSize); ++j) {
        const double value = i == j && a == b ? diagonal : random.uniform(-1, 1);
        const int row = kSize * numbers[a] + i, column = kSize * numbers[b] + j;
        entries.emplace_back(std::max(row, column), std::min(row, column), value);
      }
  };
  for (int x = 0; x < side; ++x)
    for (int y = 0; y < side; ++y) {
      join(side * x + y, side * x + y, 6.0 * kSize);
      if (x > 0) join(side * x + y, side * (x - 1) + y, 0);
      if (y > 0) join(side * x + y, side * x + y - 1, 0);
    }
  Eigen::SparseMatrix<double> matrix(kSize * side * side, kSize * side * side);
  matrix.setFromTriplets(entries.begin(), entries.end());
  return matrix;
}

std::vector<int> shuffled(int count, testing::RandomValues& random) {
  std::vector<int> numbers(count);
  std::iota(numbers.begin(), numbers.end(), 0);
  for (int i = count - 1; i > 0; --i) std::swap(numbers[i], numbers[random.index(i + 1)]);
  return numbers;
}

std::vector<simd::Lanes> in_lanes(const Eigen::VectorXd& x) {
  std::vector<simd::Lanes> lanes(x.size() / kSize, simd::Lanes{});
  for (Eigen::Index i = 0; i < x.size(); ++i) lanes[i / kSize][i % kSize] = static_cast<float>(x[i]);
  return lanes;
}

void expect_near(const std::vector<simd::Lanes>& lanes, const Eigen::VectorXd& expected) {
  const double tolerance = 1e-5 * expected.norm();
  for (Eigen::Index i = 0; i < expected.size(); ++i)
    ASSERT_NEAR(lanes[i / kSize][i % kSize], expected[i], tolerance) << i;
  for (const simd::Lanes& block : lanes) ASSERT_EQ(block[6] * block[6] + block[7] * block[7], 0);
}

TEST(BlockTriangle, SolvesAsTheSparseTriangleDoes) {
  testing::RandomValues random(3);
  for (int side = 1; side < 9; ++side) {
    const Eigen::SparseMatrix<double> matrix = grid_matrix(side, shuffled(side * side, random), random);
    const Cholesky factors(matrix);
    ASSERT_EQ(factors.info(), Eigen::Success);
    const Eigen::SparseMatrix<double> lower = factors.matrixL();
    const BlockTriangle triangle(lower);
    ASSERT_EQ(triangle.rows(), side * side);
    Eigen::VectorXd b(matrix.rows());
    for (double& value : b) value = random.uniform(-1, 1);
    std::vector<simd::Lanes> x = in_lanes(b);
    triangle.solve(x);
    expect_near(x, lower.triangularView<Eigen::Lower>().solve(b));
    triangle.solve_transposed(x);
    expect_near(x, factors.solve(b));
  }
}

TEST(BlockTriangle, OfNoRowsSolvesNothing) {
  const BlockTriangle triangle;
  EXPECT_EQ(triangle.rows(), 0);
  triangle.solve({});
  triangle.solve_transposed({});
}

TEST(EliminationOrder, KeepsFactorsOfAGridSparse) {
  constexpr int kSide = 16, kCount = kSide * kSide;
  testing::RandomValues random(5);
  const std::vector<int> start = shuffled(kCount, random);
  std::vector<std::vector<int>> neighbors(kCount);
  const auto join = [&](int a, int b) {
    neighbors[std::min(start[a], start[b])].push_back(std::max(start[a], start[b]));
  };
  for (int x = 0; x < kSide; ++x)
    for (int y = 0; y < kSide; ++y) {
      join(kSide * x + y, kSide * x + y);
      if (x > 0) join(kSide * x + y, kSide * (x - 1) + y);
      if (y > 0) join(kSide * x + y, kSide * x + y - 1);
    }
  const std::vector<int> order = elimination_order(neighbors);
  ASSERT_TRUE(std::ranges::is_permutation(order, start));
  std::vector<int> numbers(kCount);
  for (int i = 0; i < kCount; ++i) numbers[i] = order[start[i]];
  const Eigen::SparseMatrix<double> ordered = grid_matrix(kSide, numbers, random),
                                    random_order = grid_matrix(kSide, start, random);
  const auto entries = [](const Eigen::SparseMatrix<double>& matrix) {
    return Cholesky(matrix).matrixL().nestedExpression().nonZeros();
  };
  EXPECT_LT(entries(ordered), 0.4 * entries(random_order));
}

}  // namespace
}  // namespace griffith
