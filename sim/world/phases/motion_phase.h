#pragma once

#include <vector>

#include "sim/world/energy/energy_phase.h"
#include "sim/world/world_state.h"

namespace griffith {

/// Lets a rigid or sleeping body sway again.
void make_elastic(WorldState& world, Body& body);
/// Sets whether a body is untouched: then whatever strikes it is to be foretold.
void set_ballistic(WorldState& world, Body& body, bool ballistic);
void predict_rigid(const WorldState& world, Body& body, const std::vector<Vec3>& forces, double dt);
/// Moves every body by its velocities and takes the elastic state after; `external` as in predict_velocities().
void move_bodies(WorldState& world, const std::vector<Vec3>& external, double dt);
/// Moves the nodes of a body from `before` by the part of its velocities that does not deform it, in a substep of `dt`
/// [s] under `external` forces [N].
void move_without_deforming(WorldState& world, const Body& body, const BodySnapshot& before,
                            const std::vector<Vec3>& external, double dt);
/// Gives a free body the angular momentum that it had before it moved.
void restore_angular_momentum(WorldState& world, const Body& body, const BodySnapshot& before);
/// Puts the nodes of a rigid body where its motion and orientation say.
void place_rigid_nodes(WorldState& world, const Body& body);
/// A body whose numbers broke down goes on as a rigid one, at rest where it was: one lost body, not a lost scene. Where
/// its positions are lost too, it has the shape again that it had when it was made or last turned rigid, in the place
/// of its proxy. A supported one stays there for good.
void freeze_if_broken_down(WorldState& world, Body& body);
/// Takes the shape as it is now for that of a rigid body.
void make_rigid(WorldState& world, Body& body);
/// Makes a body rigid from now on, its stress gone. A free one keeps its momentum, a supported one stands still.
void freeze(WorldState& world, Body& body);
/// The sum of nodal forces on a body [N], and their torque about its center of mass [N·m].
struct Wrench {
  Vec3 force = Vec3::Zero(), torque = Vec3::Zero();
};
Wrench wrench_of(const WorldState& world, const Body& body, const std::vector<Vec3>& forces);
/// Leaves a deformable body the velocities of its motion as a whole alone.
void keep_whole_motion(WorldState& world, const Body& body);
/// The same; the energy of what is lost goes to EnergyAccount::regime_change.
void stop_deforming(WorldState& world, const Body& body);
/// Kinetic energy of a deformable body's nodes and edges [J].
double kinetic_energy_of(const WorldState& world, const Body& body);
/// Kinetic and elastic energy of a body [J].
double mechanical_energy(const WorldState& world, const Body& body);
/// Energy that a strain of this size stores all over a body [J].
double energy_of_strain(const WorldState& world, const Body& body, double strain);

}  // namespace griffith
