#pragma once

#include <Eigen/Core>

namespace griffith {

// Decompositions of matrices whose size is known at run time only. They are compiled once, because a single instance of
// Eigen's templates for them takes seconds.

/// Returns the inverse of a regular matrix by its LU factorization.
Eigen::MatrixXd dense_inverse(const Eigen::MatrixXd& matrix);

/// Returns the x of least norm among those that minimize |A x − b|, by a complete orthogonal decomposition.
Eigen::VectorXd least_squares(const Eigen::MatrixXd& a, const Eigen::VectorXd& b);

/// Eigenvalues in ascending order, and their orthonormal eigenvectors as columns.
struct SymmetricModes {
  Eigen::VectorXd values;
  Eigen::MatrixXd vectors;
};

/// Returns the eigenvalues and eigenvectors of a symmetric matrix; reads its lower triangle.
SymmetricModes symmetric_modes(const Eigen::MatrixXd& matrix);

}  // namespace griffith
