#pragma once

#include "sim/world/state/world_state.h"

namespace griffith {

/// Chooses the bodies that are quasi-static in a substep: those of large groups of contacts that cannot deform visibly
/// before they break and come to equilibrium within a time step. They touch as rigid bodies and deform under the
/// impulses that they get. The energy of that deformation is next to nothing; that of waves goes to
/// EnergyAccount::regime_change.
void choose_quasi_static_bodies(WorldState& world);

/// Returns where nodes touch, per node of the mesh [m]: those of quasi-static bodies where the undeformed ones would
/// be.
std::vector<Vec3> touching_places(const WorldState& world);

/// True if a wave crosses a body within `dt` [s]: by an implicit step of that length it comes close to equilibrium.
bool reaches_equilibrium(const WorldState& world, const Body& body, double dt);

}  // namespace griffith
