#pragma once

#include "sim/explicit/obstacle.h"
#include "sim/world/impacts/step_impacts.h"
#include "sim/world/state/world_state.h"

namespace griffith {

/// True if any body is in explicit dynamics.
bool any_explicit(const WorldState& world);

/// Begins to follow the body's waves. `impact_speed`: speed of the impact on it, if any [m/s].
void begin_explicit(WorldState& world, Body& body, double impact_speed);

/// Returns the length of the next substep, at most `left` [s]: up to the next impact that all bodies share, or as long
/// as waves are followed. Bodies that are hit in it go into explicit dynamics.
double next_substep(WorldState& world, double left, StepImpacts& impacts);

/// Begins explicit dynamics of overloaded bodies, so that their cracks run at the speed that waves allow.
void begin_explicit_if_overloaded(WorldState& world);

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
