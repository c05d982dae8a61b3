#pragma once

#include <vector>

#include "sim/world/energy/energy_phase.h"
#include "sim/world/state/world_state.h"

namespace griffith {

/// Applies the external `forces` [N] of a substep of `dt` [s] to a rigid body; its loads are recorded in `start`.
void predict_rigid(const WorldState& world, Body& body, const std::vector<Vec3>& forces, double dt, RigidStart& start);
/// Moves every body by its velocities and takes the elastic state after; `external` as in predict_velocities().
/// `moves`: by which step they were found, by BodyId.
void move_bodies(WorldState& world, const std::vector<Vec3>& external, std::vector<ElasticMove> moves, double dt);
/// True if the present velocities would give a body more energy than it had and is given in a substep.
bool would_gain_energy(WorldState& world, const Body& body, const std::vector<Vec3>& external, double dt);
/// Moves the nodes of a body from `before` by the part of its velocities that does not deform it, in a substep of `dt`
/// [s] under `external` forces [N].
void move_without_deforming(WorldState& world, const Body& body, const BodySnapshot& before,
                            const std::vector<Vec3>& external, double dt);
/// Restores the angular momentum of a free body before it moved.
void restore_angular_momentum(WorldState& world, const Body& body, const BodySnapshot& before);
/// Sum of nodal forces on a body [N], and their torque about its center of mass [N·m].
struct Wrench {
  Vec3 force = Vec3::Zero(), torque = Vec3::Zero();
};
Wrench wrench_of(const WorldState& world, const Body& body, const std::vector<Vec3>& forces);
/// Scales the velocities that deform a deformable body by `fraction`, from 0 to 1.
void slow_deformation(WorldState& world, const Body& body, double fraction);
/// Removes the velocities that deform a deformable body.
inline void keep_whole_motion(WorldState& world, const Body& body) { slow_deformation(world, body, 0); }
/// Returns the work of impulses at the velocities that deform a body [J]. `impulses`: per node of the mesh [N·s].
double deforming_work(const WorldState& world, const Body& body, const std::vector<Vec3>& impulses);
/// Does the same; the lost energy goes to EnergyAccount::regime_change.
void stop_deforming(WorldState& world, const Body& body);
/// Returns the kinetic energy of a deformable body's nodes and edges [J].
double kinetic_energy_of(const WorldState& world, const Body& body);
/// Returns the kinetic and elastic energy of a body [J].
double mechanical_energy(const WorldState& world, const Body& body);
/// Returns the energy of a uniform strain of this size in a body [J].
double energy_of_strain(const WorldState& world, const Body& body, double strain);

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
