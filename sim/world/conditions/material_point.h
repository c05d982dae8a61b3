#pragma once

#include <string>

#include "sim/world/conditions/loads.h"

namespace griffith {

struct Body;
struct WorldState;

/// Finds the point of an input with that name. Throws InputError if there is no such point, or nothing moves.
MaterialPoint place_point(const WorldState& world, const std::string& input, int tet, const Vec3& weights);

/// Returns the piece to which the point belongs now.
const Body& body_at(const WorldState& world, const MaterialPoint& point);
/// Returns the place of the point [m].
Vec3 position_of(const WorldState& world, const MaterialPoint& point);
/// Returns its velocity [m/s].
Vec3 velocity_of(const WorldState& world, const MaterialPoint& point);
/// Adds a force [N] on the point to its corners and, in a quadratic tet, to its edges.
void add_force_at(const WorldState& world, const MaterialPoint& point, const Vec3& force, ExternalForces& forces);

/// Wakes the piece with the point. Forces strain pieces, so it deforms unless it is a single element.
void wake_at(WorldState& world, const MaterialPoint& point);

}  // namespace griffith
