#pragma once

#include "sim/world/state_hashes.h"
#include "sim/world/world_state.h"

namespace griffith {

/// The hashes of a world between two steps. Costs a few hundred bytes of reading for each node and tet.
StateHashes hash_state(const WorldState& world);

}  // namespace griffith
