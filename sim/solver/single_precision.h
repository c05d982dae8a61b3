#pragma once

#include <functional>

#include "sim/solver/preconditioner.h"

namespace griffith {

/// Conjugate gradients for A d = r in single precision, from d = 0: where a matrix does not fit into the cache, time
/// goes into moving its bytes, and these are half as many. Stops when the recurrence has |r − A d| <= `target`, or as
/// conjugate_gradient() does. Rounding lets the true residual lag behind, so the caller must check it. Returns the
/// iterations made. `d` is resized.
int solve_in_single_precision(const BlockSparseMatrix& a, const RigidModePreconditioner& preconditioner,
                              const NodeVectors& r, double target, int max_iterations,
                              const std::function<bool()>& cancelled, NodeVectors& d);

}  // namespace griffith
