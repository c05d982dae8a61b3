#pragma once

#include "sim/core/linear_algebra.h"

namespace griffith {

/// Returns the rotation Q of the polar decomposition F = Q A with A symmetric and det Q = +1. For an inverted F (det F
/// < 0) the singular direction of the smallest singular value is flipped, so that the element unfolds the shortest way
/// (Irving, Teran & Fedkiw 2004). Any finite matrix is allowed, even a singular one.
Mat3 polar_rotation(const Mat3& deformation_gradient);

}  // namespace griffith
