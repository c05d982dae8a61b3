#pragma once

#include "sim/world/state/world_state.h"

namespace griffith {

/// Sets whether a body is ballistic: then all impacts on it are predicted.
void set_ballistic(WorldState& world, Body& body, bool ballistic);
/// Makes a rigid or sleeping body deformable.
void make_elastic(WorldState& world, Body& body);
/// Takes the shape as it is now for that of a rigid body.
void make_rigid(WorldState& world, Body& body);
/// Makes a free piece rigid: its remaining vibration is damped at once.
void stop_vibration(WorldState& world, Body& body);
/// Moves the nodes of a rigid body to its motion and orientation.
void place_rigid_nodes(const Body& body, NodeArrays& nodes, EdgeArrays& edges);
/// Makes a body rigid and removes its stress. A free one keeps its momentum, a supported one stands still.
void freeze(WorldState& world, Body& body);
/// Makes a body with non-finite numbers rigid, at rest where it was, so that the rest of the scene goes on. If its
/// positions are lost, it takes the shape that it had when it was made or last became rigid, at the place of its proxy.
/// A supported one stays there permanently.
void freeze_if_broken_down(WorldState& world, Body& body);

}  // namespace griffith
