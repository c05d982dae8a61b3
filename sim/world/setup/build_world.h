#pragma once

#include "sim/core/monitor.h"
#include "sim/world/setup/given_meshes.h"
#include "sim/world/world_state.h"

namespace griffith {

/// Builds meshes, bodies and the contact world. Throws InputError for meshes that cannot be simulated.
WorldState build_world(const Scene& scene, const Monitor& monitor = {}, const GivenMeshes& given = {});
/// Lumped mass of a node from its star [kg].
double node_mass(const WorldState& world, NodeId node);

}  // namespace griffith
