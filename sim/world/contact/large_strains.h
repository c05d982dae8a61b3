#pragma once

#include <functional>
#include <vector>

#include "sim/world/energy/energy_phase.h"
#include "sim/world/state/world_state.h"

namespace griffith {

/// True if few bodies are so soft that they may take nonlinear steps together with their contacts. More pieces, heaps
/// of debris, take linearized ones: their contacts would take minutes.
bool may_strain_far(const WorldState& world);

/// Nonlinear implicit steps, together with their contacts, of bodies that the linearized step would compact (or that
/// are compacted: Compaction). It would take them through themselves, and its contacts would carry them where they do
/// not touch. Newton's method: each round linearizes the step at the velocities of the last one, solves for all
/// contacts with it, and moves on so far that the incremental energy under these contacts decreases (Deformation).
/// `external`: forces per node [N]; `free`: velocities without contacts, per node [m/s]. solve() changes the velocities
/// by contacts, and may be called again. Only where may_strain_far(). Returns how bodies will move, by BodyId:
/// linearized the others.
std::vector<ElasticMove> resolve_large_strains(WorldState& world, const std::vector<Vec3>& external,
                                               const std::vector<Vec3>& free, double dt,
                                               const std::function<void()>& solve);

}  // namespace griffith
