#pragma once

// Private to sim/contact: ways of rigid bodies out of overlaps.

#include <span>

#include "sim/contact/rigid_rows.h"

namespace griffith::contact {

/// Takes a share (0..1] of a group's overlaps at the gaps of its points out by displacements that let nothing else
/// overlap, beside the true velocities: adds them to `push_velocity` [m] and `push_spin` [rad].
void push_apart(std::span<Motion> motions, RigidRows& rows, double share);

/// Takes a share (0..1] of overlaps out of groups of bodies by displacements alone: writes `push` and `push_rotation`.
/// Of each contact one body at least has to move.
void push_apart(std::span<RigidBody> bodies, std::span<const RigidContact> contacts, std::span<const RigidGroup> groups,
                double share);

}  // namespace griffith::contact
