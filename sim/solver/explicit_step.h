#pragma once

#include <span>
#include <vector>

#include "sim/elasticity/element.h"
#include "sim/mesh/tet_mesh.h"
#include "sim/solver/block_sparse_matrix.h"
#include "sim/solver/node_constraint.h"

namespace griffith {

/// Returns the highest frequency of a body, ω = √(largest eigenvalue of M⁻¹K) [rad/s], by Lanczos' method (1950) on
/// M^-½ K M^-½. An estimate from below, usually within 1 %; 0 without rows. `stiffness`: K alone [N/m], `masses`: per
/// row [kg].
double highest_frequency(const BlockSparseMatrix& stiffness, const Eigen::VectorXd& masses);

/// Returns the time step of explicit_step() [s]: 0.9 of the critical one, 2/ω for an undamped body; infinite for ω = 0.
/// Stiffness-proportional damping beta [s] shortens it: with ξ = beta ω / 2 the symplectic scheme is stable for h <=
/// (2/ω)(√(1 + ξ²) − ξ).
double stable_time_step(double highest_frequency, double stiffness_damping = 0);

/// The velocities of a step of symplectic Euler (O'Brien & Hodgins 1999 integrate explicitly, too), after which
/// x⁺ = x + h v⁺:
///   v⁺ = v + h (f/m − alpha v),
/// for `nodes`, in the directions that their constraints leave; blocked ones move with their known velocities.
/// `forces`: elastic, damping and external ones at x and v [N]; spans are per node of the mesh.
void explicit_step(double dt, double mass_damping, std::span<const NodeId> nodes,
                   std::span<const NodeConstraint> constraints, std::span<const double> masses,
                   std::span<const Vec3> forces, std::span<Vec3> velocities);

}  // namespace griffith
