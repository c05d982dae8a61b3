#pragma once

#include <vector>

#include "sim/explicit/obstacle.h"
#include "sim/world/state/world_state.h"

namespace griffith {

/// True if any body is in explicit dynamics.
bool any_explicit(const WorldState& world);

/// Begins to follow the body's waves. `impact_speed`: speed of the impact on it, if any [m/s].
void begin_explicit(WorldState& world, Body& body, double impact_speed);

/// Takes the bodies in explicit dynamics through `duration` [s] by microsteps, and with them the obstacles, which move
/// on from where they were before the others moved, at the velocities that they have now. False where it takes more
/// than `max_work` [µs of a typical core]: the world is invalid then.
bool run_explicit(WorldState& world, std::vector<explicit_dynamics::Obstacle> obstacles, double duration,
                  double max_work);

/// Returns a body to the implicit step, in the shape that its stress has under the full stiffness.
void end_explicit(WorldState& world, Body& body);

/// Ends explicit dynamics of bodies without waves.
void end_explicit_if_quiet(WorldState& world);

}  // namespace griffith
