#pragma once

#include <functional>

#include "sim/solver/preconditioner.h"

namespace griffith {

struct SolveReport {
  int iterations = 0;
  double relative_residual = 0;  ///< |b − A x| / scale
  bool converged = true;
};

/// Preconditioned conjugate gradients (Hestenes & Stiefel 1952) for A x = b, A symmetric positive definite. They start
/// from the best multiple of what is in `x` (least error in the energy norm), so that a bad guess costs nothing. Stops
/// at |b − A x| <= tolerance · scale, or when `given_up`, asked before each iteration, says so. Large matrices and
/// tolerances from 1e-5 on start in single precision, refined by residuals in double.
SolveReport conjugate_gradient(const BlockSparseMatrix& a, const RigidModePreconditioner& preconditioner,
                               const NodeVectors& b, NodeVectors& x, double tolerance, double scale, int max_iterations,
                               const std::function<bool()>& given_up = {});

}  // namespace griffith
