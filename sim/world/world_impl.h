#pragma once

#include "sim/world/world.h"
#include "sim/world/world_state.h"

namespace griffith {

struct World::Impl {
  WorldState state;
};

}  // namespace griffith
