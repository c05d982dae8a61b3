#include "sim/solver/block_triangle.h"

#include <Eigen/Core>
#include <algorithm>

namespace griffith {
namespace {

using simd::Lanes;
using ColumnEntry = Eigen::SparseMatrix<double>::InnerIterator;

/// One lane in all of them.
template <int lane>
Lanes broadcast(Lanes x) {
  return __builtin_shufflevector(x, x, lane, lane, lane, lane, lane, lane, lane, lane);
}

float sum_of(Lanes x) { return ((x[0] + x[1]) + (x[2] + x[3])) + (x[4] + x[5]); }

}  // namespace

BlockTriangle::BlockTriangle(const Eigen::SparseMatrix<double>& lower) {
  diagonals_.resize(static_cast<std::size_t>(lower.cols()) / kSize);
  for (int column = 0; column < rows(); ++column) {
    add_pattern(lower, column);
    take_values(lower, column);
  }
}

/// Elimination fills whole blocks, so the first of the six columns has them all.
void BlockTriangle::add_pattern(const Eigen::SparseMatrix<double>& lower, int column) {
  for (ColumnEntry entry(lower, kSize * column); entry; ++entry) {
    const int row = static_cast<int>(entry.row()) / kSize;
    if (row > column && (static_cast<int>(row_of_.size()) == starts_.back() || row_of_.back() != row))
      row_of_.push_back(row);
  }
  below_.resize(row_of_.size());
  starts_.push_back(static_cast<int>(row_of_.size()));
}

void BlockTriangle::take_values(const Eigen::SparseMatrix<double>& lower, int column) {
  using Matrix = Eigen::Matrix<double, kSize, kSize>;
  Matrix diagonal = Matrix::Zero();
  for (int k = 0; k < kSize; ++k)
    for (ColumnEntry entry(lower, kSize * column + k); entry; ++entry) {
      const int row = static_cast<int>(entry.row()) / kSize, lane = static_cast<int>(entry.row()) % kSize;
      if (row == column) {
        diagonal(lane, k) = entry.value();
      } else {
        const auto block = std::lower_bound(row_of_.begin() + starts_[column], row_of_.end(), row) - row_of_.begin();
        below_[block].columns[k][lane] = static_cast<float>(entry.value());
      }
    }
  const Matrix inverse = diagonal.triangularView<Eigen::Lower>().solve(Matrix::Identity());
  for (int i = 0; i < kSize; ++i)
    for (int j = 0; j < kSize; ++j)
      diagonals_[column].inverse.columns[j][i] = diagonals_[column].transposed.columns[i][j] =
          static_cast<float>(inverse(i, j));
}

Lanes BlockTriangle::product(const Block& block, Lanes x) {
  return ((block.columns[0] * broadcast<0>(x) + block.columns[1] * broadcast<1>(x)) +
          (block.columns[2] * broadcast<2>(x) + block.columns[3] * broadcast<3>(x))) +
         (block.columns[4] * broadcast<4>(x) + block.columns[5] * broadcast<5>(x));
}

void BlockTriangle::solve(std::span<Lanes> x) const {
  for (std::size_t column = 0; column < diagonals_.size(); ++column) {
    const Lanes solved = product(diagonals_[column].inverse, x[column]);
    x[column] = solved;
    for (int k = starts_[column]; k < starts_[column + 1]; ++k) x[row_of_[k]] -= product(below_[k], solved);
  }
}

void BlockTriangle::solve_transposed(std::span<Lanes> x) const {
  for (std::size_t column = diagonals_.size(); column-- > 0;) {
    Lanes products[kSize] = {};
    for (int k = starts_[column]; k < starts_[column + 1]; ++k)
      for (int i = 0; i < kSize; ++i) products[i] += below_[k].columns[i] * x[row_of_[k]];
    Lanes rest = x[column];
    for (int i = 0; i < kSize; ++i) rest[i] -= sum_of(products[i]);
    x[column] = product(diagonals_[column].transposed, rest);
  }
}

}  // namespace griffith
