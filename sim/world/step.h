#pragma once

#include "sim/world/state/world_state.h"

namespace griffith {

/// Makes a step.
void advance(WorldState& world);

}  // namespace griffith
