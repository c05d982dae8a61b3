#pragma once

#include "sim/world/state/world_state.h"

namespace griffith {

/// Opens the mesh where the utilization exceeds 1, worst first; separated pieces become bodies. Cracks beyond the
/// budget open in the next step. New cracks start no closer to each other than a wave travels in the `substep` [s].
void open_cracks(WorldState& world, double substep);

}  // namespace griffith
