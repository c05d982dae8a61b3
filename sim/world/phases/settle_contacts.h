#pragma once

#include "sim/world/phases/touched_body.h"

namespace griffith {

/// Finds anew the impulses between nodes of elastic bodies and what does not move: the ground, sleepers. All others
/// stay. The impulses that the compliance of a body tells are near enough where it is compact; those under a thin slab
/// would bend it. Here its own system decides, in which the nodes that touch are held, in their normal direction where
/// they slide, in all where they stick. Writes them to the contacts; whether any changed. Bodies have answered their
/// contacts before, and answer them again afterwards.
bool settle_contacts(WorldState& world, TouchedBodies& touched, double dt);

}  // namespace griffith
