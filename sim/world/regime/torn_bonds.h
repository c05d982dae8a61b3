#pragma once

#include <span>
#include <vector>

#include "sim/core/ids.h"

namespace griffith {

struct WorldState;

/// Breaks the bonds between parts of deformable bodies without supports that move apart with more energy than these
/// bonds can take, and parts the bodies there. For bodies whose microsteps end: as rigid ones they would stop what
/// flies apart. The bonds take their energy from the motion by impulses between the parts. Returns the pieces: the
/// bodies themselves and what parted from them.
std::vector<BodyId> part_at_torn_bonds(WorldState& world, std::span<const BodyId> bodies);

}  // namespace griffith
