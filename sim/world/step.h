#pragma once

#include "sim/world/world_state.h"

namespace griffith {

/// A whole step.
void advance(WorldState& world);

}  // namespace griffith
