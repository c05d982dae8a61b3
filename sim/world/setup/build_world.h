#pragma once

#include "sim/core/monitor.h"
#include "sim/world/setup/in_memory_meshes.h"
#include "sim/world/state/world_state.h"

namespace griffith {

/// Builds meshes, bodies and the contact world. Throws InputError for meshes that cannot be simulated.
WorldState build_world(const Scene& scene, const Monitor& monitor = {}, const InMemoryMeshes& given = {});
/// Makes room for the plastic strains of bodies whose materials yield.
void allow_flow(WorldState& world);
/// Returns the lumped mass of a node from its tets [kg].
double node_mass(const WorldState& world, NodeId node);
/// Mass that an edge's offset moves with: all of the tets around it, far more than the 8/105 of them that it has by its
/// shape. Edges are so stiff that bending does not notice, and at this mass they do not shorten stable steps [kg].
double edge_mass(const WorldState& world, EdgeId edge);

}  // namespace griffith
