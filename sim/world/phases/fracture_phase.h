#pragma once

#include "sim/world/world_state.h"

namespace griffith {

/// Opens the mesh where the utilization is passed, worst first; parted pieces become bodies. What exceeds the budget of
/// cracks opens in the next step. New cracks start no nearer to each other than a wave gets in the `substep` [s].
void open_cracks(WorldState& world, double substep);

}  // namespace griffith
