#pragma once

#include "sim/world/world_state.h"

namespace griffith {

/// Views and totals, for the frame.
void publish(WorldState& world);

}  // namespace griffith
