#pragma once

#include <Eigen/Core>
#include <functional>

#include "sim/solver/block_sparse_matrix.h"

namespace griffith {

/// Solves A x = b by a sparse LDLᵀ factorization, A symmetric positive definite. False when the factorization breaks
/// down; `x` is then left alone.
bool direct_solve(const BlockSparseMatrix& a, const NodeVectors& b, NodeVectors& x);

/// Solves A x = b by the generalized minimal residual method (Saad & Schultz 1986), A given by its products. Stops at
/// |b − A x| <= tolerance · |b| or after `max_iterations`.
Eigen::VectorXd gmres(const std::function<Eigen::VectorXd(const Eigen::VectorXd&)>& multiply, const Eigen::VectorXd& b,
                      double tolerance, int max_iterations);

}  // namespace griffith
