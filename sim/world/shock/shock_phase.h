#pragma once

#include "sim/shock/obstacle.h"
#include "sim/world/shock/step_impacts.h"
#include "sim/world/world_state.h"

namespace griffith {

/// Whether any body is in shock.
bool in_shock(const WorldState& world);

/// From now on the body's waves are resolved. `impact_speed`: of what struck it, if anything did [m/s].
void enter_shock(WorldState& world, Body& body, double impact_speed);

/// How far the step may go on in one piece, at most `left` [s]: up to the next impact that all share, or for as long as
/// waves are followed. The bodies that are struck in it are in shock then.
double next_stretch(WorldState& world, double left, StepImpacts& impacts);

/// Lets the bodies enter that load has overcome, so that their cracks run as waves let them.
void enter_overloaded_bodies(WorldState& world);

/// Takes the bodies in shock through `duration` [s] by microsteps, and with them the obstacles, which move on from
/// where they were before the others moved, at the velocities that they have now. False where it takes more than
/// `max_work` [µs of a usual core]: the world is of no use then.
bool run_shock(WorldState& world, std::vector<shock::Obstacle> obstacles, double duration, double max_work);

/// Lets a free piece move as a whole: what still vibrates in it is damped at once.
void stop_vibration(WorldState& world, Body& body);

/// The body sways again, in the shape that its stress has under its full stiffness.
void end_shock(WorldState& world, Body& body);

/// Bodies in which waves have died out sway again.
void leave_shock(WorldState& world);

}  // namespace griffith
