#pragma once

#include "sim/scene/push.h"

namespace griffith {

struct WorldState;

/// Pushes a point of material by a constant force in the next time step, whose impulse is given, and wakes its piece.
/// Throws InputError if the point does not exist, the impulse is not finite, or the scene has no motion.
void begin_push(WorldState& world, const Push& push);

/// Removes pushes whose step is over.
void end_pushes(WorldState& world);

}  // namespace griffith
