#pragma once

#include <vector>

#include "sim/solver/pivot.h"
#include "sim/world/state/world_state.h"

namespace griffith {

/// Returns the values of a body's nodes out of those per node of the mesh, a column each.
NodeVectors of_nodes(const Body& body, const std::vector<Vec3>& values);
/// Masses of a body's nodes [kg].
Eigen::VectorXd masses_of(const WorldState& world, const Body& body);
/// Returns the rotation of a body about its pivot.
Turning turning_of(const WorldState& world, const Body& body, const Pivot& pivot);

/// Moves and rotates a deformable body as a whole by `turn`, from a state of its motion to another. Its velocities
/// rotate along: left as they are, they would deform a body that spins.
void carry(WorldState& world, const Body& body, const Mat3& turn, const RigidState& before, const RigidState& after);

/// Moves a free body by its velocities: their rigid part rotates it, the rest deforms it. Along the tangents, a
/// rotation by the angle a would lengthen it by a²/2, and a stiff body would break. Linear and angular momentum are
/// conserved.
void move_free(WorldState& world, const Body& body, double dt);
/// Moves a supported body that turns about a pivot; its angular momentum about it is kept.
void move_swinging(WorldState& world, const Body& body, const Pivot& pivot, const std::vector<Vec3>& external,
                   double dt);

}  // namespace griffith
