#pragma once

#include "sim/solver/block_sparse_matrix.h"

namespace griffith {

/// Solves A x = b by a sparse LDLᵀ factorization, A symmetric positive definite. False when the factorization breaks
/// down; `x` is then left alone.
bool direct_solve(const BlockSparseMatrix& a, const NodeVectors& b, NodeVectors& x);

}  // namespace griffith
