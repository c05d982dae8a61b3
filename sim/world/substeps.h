#pragma once

// Substeps of a step of the hybrid integrator, and the bodies that go into explicit dynamics in them.

#include "sim/world/impacts/step_impacts.h"
#include "sim/world/state/world_state.h"

namespace griffith {

/// Returns the length of the next substep, at most `left` [s]: up to the next impact that all bodies share, or as long
/// as waves are followed. Bodies that are hit in it go into explicit dynamics.
double next_substep(WorldState& world, double left, StepImpacts& impacts);

}  // namespace griffith
