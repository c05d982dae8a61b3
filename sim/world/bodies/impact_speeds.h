#pragma once

#include "sim/world/state/world_state.h"

namespace griffith {

/// Returns the least speed of an impact that could cause damage and must be examined [m/s]. It is larger for a body of
/// one cell without cracks, in which no wave returns as tension before it has spread: of 2,500 random ones none broke
/// below 2.2 σ_t/(ρc), while finer meshes do from 0.77 on.
double harmful_impact_speed(const WorldState& world, const Body& body);

/// True for a material that stands strains of a twentieth before it breaks, as rubber does.
bool stands_large_strains(const Material& material);

/// Number of times that waves cross a body after its last event until they have died down.
inline constexpr double kTransits = 4;

/// Returns the time for which the waves of an impact on a body run under its full stiffness [s].
double impact_window(const WorldState& world, const Body& body);

/// True if the waves of an impact on a body take more than a small part of a step: then they are visible.
bool responds_slowly(const WorldState& world, const Body& body);

/// True for a stout body of a material that stands large strains, little damped, which responds slowly: impacts deform
/// it, but hardly break it, and it returns their energy, which implicit steps would take.
bool rebounds(const WorldState& world, const Body& body);

/// Returns the least speed of impacts on the ground in which a body that rebounds is followed by microsteps [m/s];
/// infinite for one that does not.
double rebound_speed(const WorldState& world, const Body& body);

/// Returns the least speed of impacts on a body that must be examined [m/s].
double examined_impact_speed(const WorldState& world, const Body& body);

}  // namespace griffith
