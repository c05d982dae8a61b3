#pragma once

#include <cstdint>
#include <vector>

#include "sim/solver/block_sparse_matrix.h"

namespace griffith {

/// Rows of a matrix that are eliminated together, since they leave fill in the same other rows. Rows are meant by their
/// places in the order of elimination.
struct Front {
  int first = 0, columns = 0;  ///< the rows first … first + columns − 1
  std::vector<int> below;      ///< later rows that they fill, ascending
  int parent = -1;             ///< the front with the first of `below`; -1 for none

  int rows() const { return columns + static_cast<int>(below.size()); }
};

/// An order in which Cholesky factors of a matrix of 3×3 blocks stay sparse (approximate minimum degree: Amestoy, Davis
/// & Duff 1996), and the fill that it leaves.
struct EliminationPlan {
  std::vector<int> places;    ///< place of each row of the matrix in the order of elimination
  std::vector<Front> fronts;  ///< in that order; parents come after their children

  std::int64_t entries() const;     ///< numbers of the factor
  std::int64_t operations() const;  ///< multiplications of the factorization
};

/// Takes the pattern of a symmetric matrix.
EliminationPlan plan_elimination(const BlockSparseMatrix& pattern);

}  // namespace griffith
