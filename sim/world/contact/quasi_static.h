#pragma once

#include <span>

#include "sim/world/contact/touched_body.h"
#include "sim/world/state/world_state.h"

namespace griffith {

/// Chooses the bodies that are quasi-static in a substep: those of large groups of contacts that cannot deform visibly
/// before they break and come to equilibrium within a time step. They touch as rigid bodies and deform under the
/// impulses that they get. The energy of that deformation is next to nothing.
void choose_quasi_static_bodies(WorldState& world);
/// Stops the waves in quasi-static bodies, whose energy goes to EnergyAccount::regime_change. A substep begins with it.
void stop_waves(WorldState& world);

/// Returns where nodes touch, per node of the mesh [m]: those of quasi-static bodies where the undeformed ones would
/// be.
std::vector<Vec3> touching_places(const WorldState& world);

/// Slows the deformation of quasi-static bodies where it would take more energy than the contacts of their group
/// dissipate: the inertia of what presses on them lets it go no faster. Heavy objects that are stopped within a short
/// substep would otherwise strain what they strike with many times the energy that they had. `bodies`: indices of the
/// bodies that respond.
void limit_deformation(WorldState& world, const TouchedBodies& touched, std::span<const int> bodies);

}  // namespace griffith
