#pragma once

#include "sim/solver/contact_problem.h"
#include "sim/world/contact/touched_body.h"
#include "sim/world/state/world_state.h"

namespace griffith {

/// Finds the impulses of a substep of `dt` [s] at the contacts of elastic bodies and of the rigid ones that touch them,
/// each group as one convex problem (sim/solver/contact_problem.h), and writes them into contacts(). Leaves what they
/// change in the velocities of the elastic bodies in TouchedBody::change, as found by the solver; counts contacts
/// that do not meet their law.
/// What is quasi-static takes part as a rigid body and deforms under the impulses that it got.
void solve_elastic_contacts(WorldState& world, TouchedBodies& touched, double dt);

/// Returns the inertia of a body against velocity changes in a substep of `dt` [s].
DeformableInertia deformable_inertia(const WorldState& world, const Body& body, double dt);

/// Returns the motions of a body as a whole within its supports, for the present positions of its nodes, in a substep
/// of `dt` [s].
WholeMotion whole_motion(const WorldState& world, const Body& body, double dt);

}  // namespace griffith
