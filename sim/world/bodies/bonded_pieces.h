#pragma once

#include <vector>

#include "sim/core/ids.h"

namespace griffith {

struct Body;
struct WorldState;

/// Returns the pieces of a body that faces or holding bonds connect. Each piece is ascending, and the pieces are in the
/// order of their first tets.
std::vector<std::vector<TetId>> bonded_pieces(const WorldState& world, const Body& body);

/// Breaks all bonds of a body.
void drop_bonds(WorldState& world, const Body& body);

/// Parts bodies whose bonds were dropped, and deformable ones: bonds act in explicit dynamics and in rigid bodies alone.
void part_at_bonds(WorldState& world);

}  // namespace griffith
