#pragma once

#include <functional>

#include "sim/solver/factor_preconditioner.h"
#include "sim/solver/preconditioner.h"
#include "sim/solver/whole_motion.h"

namespace griffith {

struct SolveReport {
  int iterations = 0;
  double relative_residual = 0;  ///< |b − A x| / scale
  bool converged = true;
};

/// Preconditioner of conjugate gradients: the factors of a matrix, or else rigid motions of aggregates.
struct Preconditioning {
  Preconditioning(const RigidModePreconditioner& of_modes) : modes(of_modes) {}
  Preconditioning(const RigidModePreconditioner& of_modes, const FactorPreconditioner* of_factors)
      : modes(of_modes), factors(of_factors && of_factors->exists() ? of_factors : nullptr) {}

  const RigidModePreconditioner& modes;
  const FactorPreconditioner* factors = nullptr;  ///< used where there are any

  double apply(const NodeVectors& r, NodeVectors& z) const {
    return factors ? factors->apply(r, z) : modes.apply(r, z);
  }
};

/// Preconditioned conjugate gradients (Hestenes & Stiefel 1952) for A x = b, A symmetric positive definite. They start
/// from the best multiple of what is in `x` (least error in the energy norm), so that a bad guess costs nothing. Stops
/// at |b − A x| <= tolerance · scale, or when `cancelled`, called before each iteration, returns true. Large matrices
/// and tolerances from 1e-5 on start in single precision, refined by residuals in double, unless there are factors.
/// `beside`: motions that x must not contain, and whose momentum b does not have; x then solves Pᵀ A P x = b with the
/// projection P beside them. A itself would answer a deformation with such a motion where the body is strained.
SolveReport conjugate_gradient(const BlockSparseMatrix& a, const Preconditioning& preconditioner, const NodeVectors& b,
                               NodeVectors& x, double tolerance, double scale, int max_iterations,
                               const std::function<bool()>& cancelled = {}, const WholeMotion* beside = nullptr);

}  // namespace griffith
