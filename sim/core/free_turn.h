#pragma once

#include "sim/core/linear_algebra.h"

namespace griffith {

/// The rotation of a free rigid body over `dt` [s]: its angular momentum stands still while its inertia [kg·m²] turns.
/// Angular momentum and kinetic energy after it are those before to rounding, however fast it spins: second order
/// (implicit midpoint, led back to the energy) up to about a radian, beyond that a steady turn about the momentum.
Mat3 free_turn(const Mat3& inertia, const Vec3& angular_velocity, double dt);

}  // namespace griffith
