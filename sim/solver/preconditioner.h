#pragma once

#include <Eigen/SparseCholesky>
#include <memory>
#include <span>
#include <vector>

#include "sim/core/lanes.h"
#include "sim/solver/block_sparse_matrix.h"
#include "sim/solver/block_triangle.h"

namespace griffith {

/// Eigen's sparse Cholesky factorization in the given order, as a value: a copy analyzes the pattern again when it next
/// factors.
class CopyableCholesky {
 public:
  using Solver = Eigen::SimplicialLLT<Eigen::SparseMatrix<double>, Eigen::Lower, Eigen::NaturalOrdering<int>>;

  CopyableCholesky() = default;
  CopyableCholesky(CopyableCholesky&&) noexcept = default;
  CopyableCholesky& operator=(CopyableCholesky&&) noexcept = default;
  CopyableCholesky(const CopyableCholesky&) {}
  CopyableCholesky& operator=(const CopyableCholesky&) { return *this = CopyableCholesky(); }

  /// To be called where the pattern of what factor() takes has changed.
  void forget_pattern() { solver_.reset(); }
  /// Returns the lower triangle of the factors; null where the matrix, of which the lower triangle counts, is not
  /// positive definite. Valid until the next call.
  const Eigen::SparseMatrix<double>* factor(const Eigen::SparseMatrix<double>& matrix);

 private:
  std::unique_ptr<Solver> solver_;
};

/// Three components a node and a zero, in single precision.
using SingleVectors = std::vector<simd::Quad>;

/// z = D⁻¹ r + R (Rᵀ A R)⁻¹ Rᵀ r: block Jacobi and a coarse space of the six rigid-body modes of each aggregate of
/// nodes (additive Schwarz). The iteration count depends neither on stiffness nor on cracks. If A has broken down, so
/// that the coarse matrix cannot be factored, z = D⁻¹ r.
///   A  the system matrix      D  its 3×3 block diagonal
///   R  one 3×6 block per node: [I, −[x − c]×/l], with c the aggregate's center and l the mean size of an aggregate, so
///      that all modes are of a similar size for any size of the body; rows of edges, after those of nodes, are zero
class RigidModePreconditioner {
 public:
  /// Aggregates of about `aggregate_size` nodes on the pattern of `matrix`, whose first `node_rows` rows are of nodes;
  /// values come with update().
  RigidModePreconditioner(const BlockSparseMatrix& matrix, int node_rows, int aggregate_size);

  /// Fits the aggregates to a matrix whose pattern changed; `previous_rows`: the row that each row was, -1 for new
  /// ones. Aggregates stand where they still hold together.
  void patch(const BlockSparseMatrix& matrix, const std::vector<int>& previous_rows, int aggregate_size);
  /// Takes the values of `matrix` and the positions of its nodes, one column a row [m]. The matrix must be positive
  /// definite. What is known of a matrix that differs by a thousandth does as well and is kept.
  void update(const BlockSparseMatrix& matrix, const NodeVectors& positions);
  /// Returns r·z as dot() does.
  double apply(const NodeVectors& r, NodeVectors& z) const;
  /// D⁻¹ of a row [1/kg].
  const Mat3& inverse_diagonal(int row) const { return known_.inverse_diagonal[row]; }
  /// False where the coarse matrix could not be factored.
  bool has_coarse_space() const { return triangle_.rows() > 0; }
  /// Rᵀ A R, its lower triangle, six rows and columns an aggregate.
  const Eigen::SparseMatrix<double>& coarse_matrix() const { return coarse_; }
  /// Rows of nodes, the first ones of the matrix.
  int node_rows() const { return static_cast<int>(aggregates_.size()); }
  int aggregate_of(int row) const { return aggregates_[row]; }
  /// (x − c)/l of a node in its aggregate.
  Vec3 arm(int row) const { return known_.arms.col(row); }
  /// Return how often update() assembled the coarse matrix because of changes, and factored it again.
  int assembly_count() const { return assemblies_; }
  int factorization_count() const { return factorizations_; }
  /// Returns its approximate memory [bytes].
  std::size_t memory() const;
  int aggregate_count() const { return static_cast<int>(members_.size()); }

 private:
  friend class SinglePrecisionPreconditioner;

  /// Data of a matrix and the positions of its nodes that show whether the coarse matrix changes.
  struct Fingerprint {
    NodeVectors arms;                    ///< per node: (x − c)/l
    std::vector<Mat3> inverse_diagonal;  ///< per node: changes with the stiffness
    NodeVectors pushes;                  ///< A (1, 1, 1, …), to which stiffness adds nothing: changes with the masses
  };
  Fingerprint fingerprint(const BlockSparseMatrix& matrix, const NodeVectors& positions) const;
  static bool is_close(const Fingerprint& a, const Fingerprint& b);
  NodeVectors arms(const NodeVectors& positions) const;
  void collect_members();
  void build_coarse_pattern(const BlockSparseMatrix& matrix);
  void allocate_coarse_matrix();
  void assemble_coarse_matrix(const BlockSparseMatrix& matrix);
  void factor_coarse_matrix();
  void renumber_aggregates(const std::vector<int>& numbers);
  std::vector<std::vector<int>> coarse_neighbors(const BlockSparseMatrix& matrix) const;
  template <class Vectors>
  std::vector<simd::Lanes> solve_coarse(const Vectors& r) const;

  std::vector<int> aggregates_;                // per node
  std::vector<std::vector<int>> members_;      // per aggregate: its nodes, ascending
  Fingerprint known_;                          // of the matrix that was assembled last
  bool is_patched_ = false;                    // since then
  std::vector<std::vector<int>> coarse_rows_;  // per aggregate: itself and its neighbors of a higher number
  std::vector<int> coarse_slots_;              // per block of the matrix: index into the column's coarse_rows_, or -1
  Eigen::SparseMatrix<double> coarse_;         // Rᵀ A R: the lower triangle, by 6×6 blocks
  CopyableCholesky coarse_factors_;
  BlockTriangle triangle_;   // of the factors, for apply(), which need not be more exact; empty without any
  Eigen::ArrayXd factored_;  // values of the coarse matrix when it was factored
  int assemblies_ = 0, factorizations_ = 0;
};

/// The same in single precision. Refers to the other, which must stay as it is.
class SinglePrecisionPreconditioner {
 public:
  explicit SinglePrecisionPreconditioner(const RigidModePreconditioner& of);
  /// Returns r·z. Sizes match.
  double apply(const SingleVectors& r, SingleVectors& z) const;

 private:
  struct Node {
    simd::Quad inverse_diagonal[3];  ///< columns
    simd::Quad arm;
  };
  const RigidModePreconditioner* of_;
  std::vector<Node> nodes_;
};

}  // namespace griffith
