#pragma once

#include "sim/solver/contact_problem.h"
#include "sim/world/world_state.h"

namespace griffith {

/// Returns the motions of a body as a whole within its supports, for the present positions of its nodes, in a substep
/// of `dt` [s].
WholeMotion whole_motion(const WorldState& world, const Body& body, double dt);

}  // namespace griffith
