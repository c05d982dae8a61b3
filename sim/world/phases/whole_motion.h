#pragma once

#include "sim/solver/contact_problem.h"
#include "sim/world/world_state.h"

namespace griffith {

/// The motions of a body as a whole that its supports leave free, from where its nodes are, in a substep of `dt` [s].
WholeMotion whole_motion(const WorldState& world, const Body& body, double dt);

}  // namespace griffith
