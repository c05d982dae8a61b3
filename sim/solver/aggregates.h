#pragma once

#include <vector>

#include "sim/solver/block_sparse_matrix.h"

namespace griffith {

/// Groups the rows of a matrix into connected aggregates of about `target_size` rows, greedily along its graph, so that
/// a crack parts them. Returns the aggregate of each row; aggregates are numbered from 0 without gaps.
std::vector<int> aggregate_rows(const BlockSparseMatrix& matrix, int target_size);

}  // namespace griffith
