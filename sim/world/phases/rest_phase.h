#pragma once

#include "sim/world/world_state.h"

namespace griffith {

/// Free bodies whose stress has died turn rigid: at once where nothing touched them and there is none, and single tets,
/// which cannot break. Those that loads strain stay elastic.
void rigidify_quiet_bodies(WorldState& world);
/// Turns a free body rigid at once where neither stress nor waves come near what could hurt it.
void rigidify_if_quiescent(WorldState& world, Body& body);
/// What lies still among others that do so too falls asleep, after a step of this length [s]: rigid bodies, and those
/// that have settled under a stress that stays. Sleepers keep their stress and reactions of supports, and cost nothing.
void update_sleep(WorldState& world, double time_step);
/// Lets bodies awake that the contact world found disturbed, in a substep of `dt` [s].
void wake_disturbed_bodies(WorldState& world, double dt);
/// Lets a body that deforms from now on take part in the contacts of a substep of `dt` [s] that began without it. What
/// `slept` gets the velocities that its weight and stress give it: without, contacts would push it off its place.
void join_substep(WorldState& world, Body& body, bool slept, double dt);

}  // namespace griffith
