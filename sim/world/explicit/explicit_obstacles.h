#pragma once

#include <vector>

#include "sim/explicit/obstacle.h"
#include "sim/world/world_state.h"

namespace griffith {

/// The rigid things that bodies in explicit dynamics may run into within `duration` [s], as they are now.
std::vector<explicit_dynamics::Obstacle> reachable_obstacles(const WorldState& world, double duration);

/// The ground, if there is one, as something that bodies in explicit dynamics run into.
void add_ground(const WorldState& world, std::vector<explicit_dynamics::Obstacle>& obstacles);
/// A body that keeps its shape as such a thing. `spacing`: of the points along its edges, at most [m].
explicit_dynamics::Obstacle obstacle_of(const WorldState& world, const Body& body, double spacing);
explicit_dynamics::Obstacle obstacle_of(const WorldState& world, const Projectile& projectile, double spacing);

/// Gives obstacles the velocities that what they stand for has now, before the microsteps.
void read_back_velocities(const WorldState& world, std::vector<explicit_dynamics::Obstacle>& obstacles);
/// Moves what an obstacle stands for to where the microsteps have brought it.
void place_obstacle(WorldState& world, const explicit_dynamics::Obstacle& obstacle);
/// Moves and turns a body as a whole to a place, its deformation along, and gives it velocities.
void place_body(WorldState& world, Body& body, const RigidState& state);

}  // namespace griffith
