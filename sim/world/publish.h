#pragma once

#include "sim/world/world_state.h"

namespace griffith {

/// Adds the contacts of a substep that carry an impulse to those of the step, for the frame.
void record_contacts(WorldState& world);
/// Views and totals, for the frame.
void publish(WorldState& world);

}  // namespace griffith
