#pragma once

#include "sim/world/state/world_state.h"

namespace griffith {

/// Makes free bodies rigid whose stress has decayed: at once if they have neither contacts nor stress, and single tets,
/// which cannot break. Bodies strained by loads stay elastic.
void rigidify_quiet_bodies(WorldState& world);
/// Makes a free body rigid at once if it is quiescent: neither stress nor waves are large enough for damage.
void rigidify_if_quiescent(WorldState& world, Body& body);
/// Puts bodies to sleep that are still among others that are, after a step of this length [s]: rigid bodies, and those
/// that have settled under a constant stress. Sleepers keep their stress and reactions of supports, and cost nothing.
void update_sleep(WorldState& world, double time_step);
/// Wakes bodies that the contact world found disturbed, in a substep of `dt` [s].
void wake_disturbed_bodies(WorldState& world, double dt);
/// Includes a body that becomes deformable in the contacts of a substep of `dt` [s] that began without it. If it
/// `slept`, it gets the velocities by its weight and stress; without them contacts would push it off its place.
void join_substep(WorldState& world, Body& body, bool slept, double dt);

}  // namespace griffith
