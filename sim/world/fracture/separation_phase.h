#pragma once

#include "sim/fracture/mean_tension.h"
#include "sim/fracture/separation_tensor.h"
#include "sim/world/state/world_state.h"

namespace griffith {

/// Computes separation tensors, and the utilization of every node. `averaged`: the stress is the mean of this
/// evaluation and the last, so that the noise of a stiff body in motion causes no cracks.
void evaluate_separation(WorldState& world, bool averaged);
/// Evaluates one body, under its stress as it is now.
void evaluate_separation(WorldState& world, const Body& body);
/// Evaluates the pieces of a body of the scene again under the stresses of the last evaluation, after its resistance
/// has changed: under the mean where that was one.
void reevaluate_separation(WorldState& world, int scene_body);
/// Returns the largest utilization of a body's nodes in the last evaluation.
double peak_utilization(const WorldState& world, const Body& body);
/// Returns the edge length of the cells around a node: that of a cube of six of its tets [m].
double element_size_at(const WorldState& world, NodeId node);
/// Returns screening_resistance() of a node.
double screening_resistance_at(const WorldState& world, const Material& material, NodeId node, bool at_front);
/// Returns the way from a node to the path of the crack that ends at it, as it is now [m].
Vec3 path_offset_at(const WorldState& world, NodeId node);
/// Returns the energy that a crack across a plane through a node takes, by the weakness of the body [J/m²].
double fracture_energy_at(const WorldState& world, NodeId node, const Vec3& normal);
/// Returns the zone over which the tension at a node counts.
TensionZone tension_zone_at(const WorldState& world, TensionZones& zones, NodeId node);
/// Evaluates nodes under the present states of their elements and zones.
void evaluate_nodes(WorldState& world, const SeparationInput& input, std::span<const NodeId> nodes, bool averaged);
/// Returns the data of the separation tensors.
SeparationInput separation_input(const WorldState& world);

}  // namespace griffith
