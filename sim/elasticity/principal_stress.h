#pragma once

#include "sim/linear_algebra.h"

namespace griffith {

/// Eigenvalues and unit eigenvectors (columns) of a symmetric matrix, ascending.
struct PrincipalValues {
  Vec3 values;
  Mat3 directions;
};
PrincipalValues principal_values(const Mat3& symmetric);

/// The tensile part of a stress: sum of max(0, v_i) n_i n_iᵀ over its eigenpairs (O'Brien & Hodgins 1999, eq. 12).
/// Exact to rounding, relative to the norm of the stress. Any finite symmetric matrix is allowed.
Mat3 tensile_part(const Mat3& stress);

}  // namespace griffith
