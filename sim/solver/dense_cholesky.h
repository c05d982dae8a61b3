#pragma once

#include <cstddef>

namespace griffith {

/// A dense matrix in columns that belongs to someone else: entry (i, j) is values[i + j * stride].
struct DenseColumns {
  double* values = nullptr;
  int rows = 0, columns = 0;
  int stride = 0;  ///< >= rows

  double* column(int j) const { return values + static_cast<long>(j) * stride; }
};

/// Replaces the columns of a symmetric matrix, from its diagonal on downward, by those of its Cholesky factor L:
/// `panel` has at least as many rows as columns. Entries above the diagonal become undefined. False where a pivot is
/// not positive. The same bits for any instruction set and number of threads.
bool factor_panel(const DenseColumns& panel);

/// C becomes C − A Aᵀ from its diagonal on downward; A has as many rows as C. Entries above become undefined.
void subtract_square(const DenseColumns& c, const DenseColumns& a);

/// Σ aᵢ bᵢ, in an order that does not depend on the instruction set.
double dot_product(const double* a, const double* b, std::size_t count);

}  // namespace griffith
