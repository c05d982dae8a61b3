#pragma once

#include <Eigen/SparseCore>
#include <span>
#include <vector>

#include "sim/core/lanes.h"

namespace griffith {

/// A lower triangular matrix L of 6×6 blocks in single precision, to solve with. Vectors have the six numbers of a
/// block in the first lanes of one entry, the others 0.
class BlockTriangle {
 public:
  static constexpr int kSize = 6;

  /// Triangle without rows.
  BlockTriangle() = default;
  /// `lower`: as sparse Cholesky gives it for a matrix of such blocks, with no zero on its diagonal.
  explicit BlockTriangle(const Eigen::SparseMatrix<double>& lower);

  /// Rows of blocks.
  int rows() const { return static_cast<int>(diagonals_.size()); }
  /// x becomes L⁻¹ x.
  void solve(std::span<simd::Lanes> x) const;
  /// x becomes L⁻ᵀ x.
  void solve_transposed(std::span<simd::Lanes> x) const;
  /// Returns its approximate memory [bytes].
  std::size_t memory() const {
    return below_.size() * (sizeof(Block) + sizeof(int)) + diagonals_.size() * 2 * sizeof(Block);
  }

 private:
  struct Block {
    simd::Lanes columns[kSize] = {};
  };
  /// Inverses of a block on the diagonal and of its transpose.
  struct Diagonal {
    Block inverse, transposed;
  };
  static simd::Lanes product(const Block& block, simd::Lanes x);
  void add_pattern(const Eigen::SparseMatrix<double>& lower, int column);
  void take_values(const Eigen::SparseMatrix<double>& lower, int column);

  std::vector<int> starts_ = {0};  ///< per column of blocks, into what is below the diagonal, and the end
  std::vector<int> row_of_;        ///< per block below the diagonal
  std::vector<Block> below_;
  std::vector<Diagonal> diagonals_;
};

}  // namespace griffith
