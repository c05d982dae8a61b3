#pragma once

#include <span>

#include "sim/world/contact/touched_body.h"
#include "sim/world/state/world_state.h"

namespace griffith {

/// Moves elastic bodies by the impulses at their contacts in a substep of `dt` [s], from their present velocities. Sets
/// Scratch::contact_impulses, the work of the contacts and the reactions of supports.
void respond(WorldState& world, TouchedBodies& touched, double dt);
/// Does the same for some of the bodies, given by their indices.
void respond(WorldState& world, TouchedBodies& touched, std::span<const int> bodies, double dt);

}  // namespace griffith
