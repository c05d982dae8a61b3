#pragma once

#include <vector>

#include "sim/solver/block_sparse_matrix.h"

namespace griffith {

/// Groups the rows of a matrix into connected aggregates of about `target_size` rows, greedily along its graph, so that
/// a crack parts them. Returns the aggregate of each row; aggregates are numbered from 0 without gaps.
std::vector<int> aggregate_rows(const BlockSparseMatrix& matrix, int target_size);

/// Fits aggregates to a matrix whose graph has lost links, rows or parts of rows. `aggregates`: the previous ones, per
/// row, -1 for a new row. New rows join a neighbor's aggregate. Rows of one aggregate that are no longer connected are
/// grouped again.
std::vector<int> patch_aggregates(const BlockSparseMatrix& matrix, int target_size, std::vector<int> aggregates);

/// Other numbers for the aggregates, by which Cholesky factors of a matrix with their pattern stay sparse (approximate
/// minimum degree: Amestoy, Davis & Duff 1996). `neighbors`: of each aggregate, those of a higher number at least.
std::vector<int> elimination_order(const std::vector<std::vector<int>>& neighbors);

}  // namespace griffith
