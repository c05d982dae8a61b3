#pragma once

#include <memory>
#include <span>
#include <vector>

#include "sim/core/lanes.h"
#include "sim/solver/elimination_plan.h"

namespace griffith {

/// A sparse Cholesky factorization A = Pᵀ L Lᵀ P of a symmetric positive definite matrix of 3×3 blocks, by fronts
/// (multifrontal method: Duff & Reid 1983; Liu 1992). The same bits for any number of threads.
///
/// Vectors are three numbers a row, by the places of rows in the order of elimination (P v).
class BlockCholesky {
 public:
  /// Factors a matrix of the plan's pattern; null where it is not positive definite.
  static std::shared_ptr<const BlockCholesky> factor(std::shared_ptr<const EliminationPlan> plan,
                                                     const BlockSparseMatrix& a);

  /// Space for factor_again(), kept from one call to the next.
  struct Workspace {
    std::vector<std::vector<double>> free;  ///< Schur complements that are not in use
  };
  /// Makes a factorization for factor_again(), without values.
  explicit BlockCholesky(std::shared_ptr<const EliminationPlan> plan);
  /// Factors another matrix of the plan's pattern in place; false where it is not positive definite.
  bool factor_again(const BlockSparseMatrix& a, Workspace& space);

  const EliminationPlan& plan() const { return *plan_; }
  /// x becomes L⁻¹ x; of four vectors at once with a simd::WideQuad.
  void solve(std::span<double> x) const { solve_forward(x); }
  void solve(std::span<simd::WideQuad> x) const { solve_forward(x); }
  /// x becomes L⁻ᵀ x.
  void solve_transposed(std::span<double> x) const;
  /// Returns its approximate memory [bytes].
  std::size_t memory() const { return values_.size() * sizeof(double); }

 private:
  template <class Number>
  void solve_forward(std::span<Number> x) const;
  double* columns_of(std::size_t front) { return values_.data() + starts_[front]; }
  const double* columns_of(std::size_t front) const { return values_.data() + starts_[front]; }

  std::shared_ptr<const EliminationPlan> plan_;
  std::vector<std::size_t> starts_;  // per front, into the values, and the end
  std::vector<double> values_;       // the columns of each front from its first row on, column after column
};

}  // namespace griffith
