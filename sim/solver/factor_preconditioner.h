#pragma once

#include <array>
#include <memory>
#include <span>
#include <vector>

#include "sim/core/ids.h"
#include "sim/elasticity/element.h"
#include "sim/solver/block_cholesky.h"
#include "sim/solver/element_rows.h"

namespace griffith {

/// z = R P (L Lᵀ)⁻¹ Pᵀ Rᵀ r: Cholesky factors of the matrix A of a body in an earlier configuration, and the rotation R
/// of the body since. While its elements turn against each other by less than thickness over length, conjugate
/// gradients need a few iterations, however thin the body is. The factorization is repeated when elements have turned,
/// or the time step has changed, too much, or the iterations that this would have saved add up to its cost.
class FactorPreconditioner {
 public:
  /// True if factors of a matrix are small enough to keep.
  static bool is_affordable(const EliminationPlan& plan);
  /// Takes the elements that A is made of; their states come with update().
  FactorPreconditioner(EliminationPlan plan, std::vector<TetId> tets);

  /// Takes the values of A, by which factors of mass and stiffness, and the states of elements, per tet of the mesh.
  void update(const BlockSparseMatrix& matrix, const MatrixFactors& made_of, std::span<const ElementState> states);
  /// Takes the iterations that a solve needed.
  void count_iterations(int iterations);
  /// False before the first update() and where A was not positive definite.
  bool exists() const { return state_ != nullptr; }
  const EliminationPlan& plan() const { return *plan_; }
  /// Returns r·z.
  double apply(const NodeVectors& r, NodeVectors& z) const;

  /// Return the two halves of apply(): L⁻¹ Pᵀ Rᵀ r, three numbers a row in the order of elimination, and R P L⁻ᵀ of
  /// such.
  std::vector<double> reduce(const NodeVectors& r) const;
  void expand(std::vector<double> reduced, Eigen::Ref<NodeVectors> z) const;
  /// reduce() of four at once, one a lane.
  std::vector<simd::WideQuad> reduce(const std::array<NodeVectors, simd::kDoubleLanes>& r) const;

  int factorization_count() const { return factorizations_; }
  /// Returns its approximate memory [bytes].
  std::size_t memory() const;
  bool shares_with(const FactorPreconditioner& other) const { return state_ == other.state_; }

 private:
  /// Data that copies share.
  struct Factored {
    std::shared_ptr<const BlockCholesky> factors;
    MatrixFactors made_of;
    std::vector<Mat3> frames;  ///< frames of the elements
  };
  void factor(const BlockSparseMatrix& matrix, const MatrixFactors& made_of, std::span<const ElementState> states);
  bool still_hold(const MatrixFactors& made_of, std::span<const ElementState> states) const;

  std::shared_ptr<const EliminationPlan> plan_;
  std::shared_ptr<const std::vector<TetId>> tets_;
  std::shared_ptr<const Factored> state_;
  Mat3 rotation_ = Mat3::Identity();  // R
  int fresh_iterations_ = -1;         // of the first solve with the factors, -1 before
  int wasted_iterations_ = 0;         // beyond those since
  int factorizations_ = 0;
};

}  // namespace griffith
