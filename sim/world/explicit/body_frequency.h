#pragma once

#include "sim/world/state/world_state.h"

namespace griffith {

/// Returns the highest frequency of the body's elements under the full stiffness, without slivers that are relieved
/// [rad/s].
double highest_frequency(const WorldState& world, const Body& body);

/// Updates the frequency limit of a body in explicit dynamics, which may be a new piece.
void limit_frequency(const WorldState& world, Body& body);

}  // namespace griffith
