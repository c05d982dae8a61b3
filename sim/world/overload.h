#pragma once

// Bodies that an implicit substep overloads: their cracks run in explicit dynamics, at the speed that waves allow.

#include "sim/world/state/world_state.h"

namespace griffith {

/// True if an implicit substep may overload bodies.
bool may_overload(const WorldState& world);

/// Returns the fraction of the implicit substep since `before`, at most 1, after which a body suited to microsteps was
/// overloaded, if its stress follows a load that changes evenly. Returns 1 if no utilization was a percent above 1.
///   last_over_this  length of the substep before over that of this one
double fraction_until_overload(const WorldState& before, const WorldState& world, double last_over_this);

/// True if the damping of the last implicit substep, `dt` [s], took so much energy from a body and from what it stopped
/// that it may have held by that alone. `shortest`: length of the shortest substep of a body that is not thin [s].
bool may_be_held_by_damping(const WorldState& world, double dt, double shortest);

/// Begins explicit dynamics of overloaded bodies.
void begin_explicit_if_overloaded(WorldState& world);

}  // namespace griffith
