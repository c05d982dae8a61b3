#pragma once

#include <vector>

#include "sim/world/energy/energy_phase.h"

namespace griffith {

/// Moves a body by the nonlinear implicit step of `dt` [s] instead of the linearized one, which strains bodies that
/// rotate far in a step. Its motion as a whole and the impulses of its contacts are kept; the velocities that deform it
/// minimize
///   ½ eᵀ M e + ½ h β eᵀ K e − eᵀ (M v + h f_external + p) + Ψ(x + h e)
/// (Martin, Thomaszewski, Grinspun & Gross 2011), so that its energy does not exceed the energy that it had and
/// received. Newton's method with the matrix of the moved body and a line search finds them. `before`: the body with
/// the solved velocities, before it moved; the present nodes are moved by them. `external`: forces per node of the mesh
/// [N]. Returns false if it did not converge.
bool move_nonlinearly(WorldState& world, Body& body, const BodySnapshot& before, const std::vector<Vec3>& external,
                      double dt);

}  // namespace griffith
