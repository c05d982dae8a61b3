#pragma once

#include "sim/world/world_state.h"

namespace griffith {

/// Free bodies whose stress has died turn rigid: at once where nothing touched them and there is none, and single tets,
/// which cannot break. Those that loads strain stay elastic.
void rigidify_quiet_bodies(WorldState& world);
/// Makes a free body rigid at once if it is quiescent: neither stress nor waves are large enough for damage.
void rigidify_if_quiescent(WorldState& world, Body& body);
/// Puts bodies to sleep that are still among others that are, after a step of this length [s]: rigid bodies, and those
/// that have settled under a constant stress. Sleepers keep their stress and reactions of supports, and cost nothing.
void update_sleep(WorldState& world, double time_step);
/// Lets bodies awake that the contact world found disturbed, in a substep of `dt` [s].
void wake_disturbed_bodies(WorldState& world, double dt);
/// Lets a body that deforms from now on take part in the contacts of a substep of `dt` [s] that began without it. What
/// `slept` gets the velocities that its weight and stress give it: without, contacts would push it off its place.
void join_substep(WorldState& world, Body& body, bool slept, double dt);

}  // namespace griffith
