#pragma once

#include <vector>

#include "sim/world/state/world_state.h"

namespace griffith {

/// Updates the elastic state of a body's tets, or of all bodies that are not rigid.
void update_elements(WorldState& world, const Body& body);
void update_elements(WorldState& world);
/// Assembles the systems of elastic bodies for a substep of `dt` [s].
void assemble_systems(WorldState& world, double dt);
/// Assembles the system of one body that was rigid before.
void assemble_system(const WorldState& world, Body& body, double dt);
/// Computes the velocities after a substep of `dt` [s] under `external` and elastic forces [N] without contacts. Nodes
/// of rigid bodies keep theirs until they move.
void predict_velocities(WorldState& world, std::vector<Vec3> external, double dt);
/// Does the same for one deformable body.
void predict_velocities(WorldState& world, Body& body, std::vector<Vec3> external, double dt);
/// Returns the implicit step of a body.
ImplicitStep implicit_step(const WorldState& world, const Body& body, double dt);
/// Adds the elastic forces of a body's nodes to `forces`, per node of the mesh [N]; sets Scratch::edge_forces of its
/// edges.
void add_elastic_forces(const WorldState& world, const Body& body, std::vector<Vec3>& forces, Scratch& scratch);

}  // namespace griffith
