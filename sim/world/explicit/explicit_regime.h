#pragma once

#include "sim/explicit/obstacle.h"
#include "sim/world/explicit/step_impacts.h"
#include "sim/world/world_state.h"

namespace griffith {

/// Whether any body is in explicit dynamics.
bool any_explicit(const WorldState& world);

/// From now on the body's waves are resolved. `impact_speed`: of what struck it, if anything did [m/s].
void begin_explicit(WorldState& world, Body& body, double impact_speed);

/// How far the step may go on in one piece, at most `left` [s]: up to the next impact that all share, or for as long as
/// waves are followed. The bodies that are struck in it are in explicit dynamics then.
double next_substep(WorldState& world, double left, StepImpacts& impacts);

/// Lets the bodies enter that load has overcome, so that their cracks run as waves let them.
void begin_explicit_if_overloaded(WorldState& world);

/// Takes the bodies in explicit dynamics through `duration` [s] by microsteps, and with them the obstacles, which move
/// on from where they were before the others moved, at the velocities that they have now. False where it takes more
/// than `max_work` [µs of a usual core]: the world is of no use then.
bool run_explicit(WorldState& world, std::vector<explicit_dynamics::Obstacle> obstacles, double duration,
                  double max_work);

/// Lets a free piece move as a whole: what still vibrates in it is damped at once.
void stop_vibration(WorldState& world, Body& body);

/// The body sways again, in the shape that its stress has under its full stiffness.
void end_explicit(WorldState& world, Body& body);

/// Bodies in which waves have died out sway again.
void end_explicit_if_quiet(WorldState& world);

}  // namespace griffith
