#pragma once

#include <vector>

#include "sim/world/contact/elastic_contacts.h"
#include "sim/world/energy/energy_phase.h"
#include "sim/world/state/world_state.h"

namespace griffith {

/// True if bodies are so soft that they may take nonlinear steps together with their contacts.
bool may_strain_far(const WorldState& world);

/// State of nodes and edges in a substep before their contacts act.
struct BeforeContacts {
  std::vector<Vec3> velocities, edge_velocities;  ///< [m/s]
  std::vector<Vec3> reactions;                    ///< per node [N]
};

/// Nonlinear implicit steps, together with their contacts, of bodies that the linearized step would compact (or that
/// are compacted: Compaction). It would take them through themselves, and its contacts would carry them where they do
/// not touch. Newton's method: each round linearizes the step at the velocities of the last one, solves for all
/// contacts of their groups with it, and moves on so far that the incremental energy under these contacts decreases
/// (Deformation). Rounds also go on until contacts are those at the places to which soft bodies turn in the substep.
/// `external`: forces per node [N]; the present velocities are those with the solved contacts. Returns how bodies will
/// move, by BodyId: linearized the others.
std::vector<ElasticMove> resolve_large_strains(WorldState& world, SolvedContacts& solved,
                                               const std::vector<Vec3>& external, const BeforeContacts& before,
                                               double dt);

}  // namespace griffith
