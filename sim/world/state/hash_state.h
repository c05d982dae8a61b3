#pragma once

#include "sim/world/state/state_hashes.h"
#include "sim/world/state/world_state.h"

namespace griffith {

/// Returns the hashes of a world between two steps. Reads a few hundred bytes per node and tet.
StateHashes hash_state(const WorldState& world);

}  // namespace griffith
