#pragma once

#include <Eigen/SparseCholesky>
#include <vector>

namespace griffith {

/// Static condensation of a coarse matrix A onto the aggregates that contacts touch (Guyan 1965): while contacts change
/// their stiffness, only the Schur complement S = A₁₁ − A₁₀ A₀₀⁻¹ A₀₁ of the touched aggregates 1 is factored again.
class CoarseReduction {
 public:
  /// Takes the lower triangle of A, six rows and columns an aggregate, and the aggregates to keep, ascending. Keeps all
  /// of them where elimination would not pay.
  CoarseReduction(const Eigen::SparseMatrix<double>& coarse, const std::vector<int>& touched);

  int kept() const { return static_cast<int>(kept_.size()); }
  /// Index of an aggregate among the kept ones, -1 if it is eliminated.
  int slot(int aggregate) const { return slots_[aggregate]; }
  /// Lower triangle of S [kg].
  const Eigen::SparseMatrix<double>& matrix() const { return matrix_; }

  /// Takes a residual of all aggregates; returns the one that is left to the kept ones.
  Eigen::VectorXd restrict(const Eigen::VectorXd& residual) const;
  /// Returns the solution of all aggregates by that of the kept ones and the residual of all.
  Eigen::VectorXd extend(const Eigen::VectorXd& kept, const Eigen::VectorXd& residual) const;

 private:
  using Factors = Eigen::SimplicialLLT<Eigen::SparseMatrix<double>>;

  void eliminate(const Eigen::SparseMatrix<double>& coarse);
  Eigen::VectorXd gather(const Eigen::VectorXd& all, const std::vector<int>& aggregates) const;

  std::vector<int> kept_, eliminated_;    // aggregates
  std::vector<int> slots_, other_slots_;  // per aggregate: its index in either, or -1
  Eigen::SparseMatrix<double> matrix_;
  Factors factors_;          // of A₀₀
  Eigen::MatrixXd carried_;  // A₀₀⁻¹ A₀₁
};

}  // namespace griffith
