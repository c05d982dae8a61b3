#pragma once

#include "sim/world/state/world_state.h"

namespace griffith {

/// Returns the least speed of an impact that could cause damage and must be examined [m/s]. It is larger for a body of
/// one cell without cracks, in which no wave returns as tension before it has spread: of 2,500 random ones none broke
/// below 2.2 σ_t/(ρc), while finer meshes do from 0.77 on.
double harmful_impact_speed(const WorldState& world, const Body& body);

/// True for a material that stands strains of a twentieth before it breaks, as rubber does.
bool stands_large_strains(const Material& material);

/// True if the waves of an impact on a body take more than a small part of a step: then they are visible.
bool responds_slowly(const WorldState& world, const Body& body);

/// True for a stout body of a material that stands large strains: impacts deform it, but hardly break it, and it
/// returns their energy, which implicit steps would take. Not for one that responds slowly and whose material is damped
/// much.
bool rebounds(const WorldState& world, const Body& body);

/// Returns the least speed of impacts in which a body that rebounds is followed by microsteps [m/s]. Infinite for one
/// that does not, and for one so stiff that it rebounds as a rigid body does.
double rebound_speed(const WorldState& world, const Body& body);

/// Returns the least speed of impacts on a body that must be examined [m/s].
double examined_impact_speed(const WorldState& world, const Body& body);

}  // namespace griffith
