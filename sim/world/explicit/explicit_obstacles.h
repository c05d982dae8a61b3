#pragma once

#include <vector>

#include "sim/explicit/obstacle.h"
#include "sim/world/state/world_state.h"

namespace griffith {

/// Returns the rigid objects that bodies in explicit dynamics may hit within `duration` [s], in their present state.
std::vector<explicit_dynamics::Obstacle> reachable_obstacles(const WorldState& world, double duration);

/// Adds the ground, if there is one, as an obstacle.
void add_ground(const WorldState& world, std::vector<explicit_dynamics::Obstacle>& obstacles);
/// Returns the obstacle for a body that keeps its shape, with this motion of its center of mass as far as its supports
/// let it. `spacing`: largest distance of the points along its edges [m].
explicit_dynamics::Obstacle obstacle_of(const WorldState& world, const Body& body, const RigidState& state,
                                        double spacing);
explicit_dynamics::Obstacle obstacle_of(const WorldState& world, const Projectile& projectile, double spacing);

/// Sets the velocities of obstacles to the present ones of their objects, before the microsteps.
void read_back_velocities(const WorldState& world, std::vector<explicit_dynamics::Obstacle>& obstacles);
/// Moves the object of an obstacle to where the microsteps have brought it.
void place_obstacle(WorldState& world, const explicit_dynamics::Obstacle& obstacle);
/// Moves and rotates a body as a whole, with its deformation, to a place, and sets its velocities.
void place_body(WorldState& world, Body& body, const RigidState& state);

}  // namespace griffith
