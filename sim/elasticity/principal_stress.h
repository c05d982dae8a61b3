#pragma once

#include <array>

#include "sim/core/linear_algebra.h"

namespace griffith {

/// Eigenvalues and unit eigenvectors (columns) of a symmetric matrix, ascending.
struct PrincipalValues {
  Vec3 values;
  Mat3 directions;
};
PrincipalValues principal_values(const Mat3& symmetric);

/// Largest principal value and a unit direction of it, in a third of the time of all.
struct LargestPrincipal {
  double value = 0;
  Vec3 direction = Vec3::UnitX();
};
LargestPrincipal largest_principal(const Mat3& symmetric);
/// Returns those of four matrices side by side, with the bits of one at a time.
std::array<LargestPrincipal, 4> largest_principals(const std::array<Mat3, 4>& symmetric);

/// Returns the largest principal values within 2e-8 of the norms.
std::array<double, 4> largest_principal_values(const std::array<Mat3, 4>& symmetric);

/// Returns the principal stresses, largest first [Pa]. More accurate than principal_values(), and NaN for a stress that
/// is not finite.
Vec3 principal_stresses(const Mat3& stress);

/// Returns the von Mises stress √(3/2 s:s), s the deviator of `stress` [Pa].
double von_mises_stress(const Mat3& stress);

/// Returns the tensile part of a stress: the sum of max(0, v_i) n_i n_iᵀ over its eigenpairs (O'Brien & Hodgins 1999,
/// eq. 12). Exact to rounding, relative to the norm of the stress. Any finite symmetric matrix is allowed.
Mat3 tensile_part(const Mat3& stress);

}  // namespace griffith
