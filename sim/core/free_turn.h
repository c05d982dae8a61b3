#pragma once

#include "sim/core/linear_algebra.h"

namespace griffith {

/// Returns the rotation of a free rigid body over `dt` [s], with constant angular momentum and an inertia [kg·m²] that
/// rotates with the body. Angular momentum and kinetic energy are kept to rounding at any speed. Second order (implicit
/// midpoint, projected back onto the energy) up to about a radian; beyond that, a steady rotation about the momentum.
Mat3 free_turn(const Mat3& inertia, const Vec3& angular_velocity, double dt);

}  // namespace griffith
