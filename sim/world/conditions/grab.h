#pragma once

#include <optional>

#include "sim/world/conditions/loads.h"
#include "sim/world/output/frame.h"

namespace griffith {

struct Body;
struct WorldState;

/// Begins a grab, in place of the present one if there is one, and wakes the piece. Throws InputError if the point does
/// not exist or the scene has no motion.
void begin_grab(WorldState& world, const Grab& grab);
/// Sets the target [m]. Throws InputError if nothing is grabbed or it is not finite.
void move_grab(WorldState& world, const Vec3& target);
/// Ends the grab, if there is one.
void end_grab(WorldState& world);

/// Returns the load of the grab; null if there is none.
PlacedLoad* present_grab(WorldState& world);
/// Returns the piece to which the grabbed point belongs now.
const Body& grabbed_body(const WorldState& world, const Grab& grab);
/// Returns the place of the grabbed point [m].
Vec3 grabbed_position(const WorldState& world, const Grab& grab);
/// Constants of the spring for the piece that it holds now.
struct SpringConstants {
  double stiffness = 0, damping = 0, max_force = 0;  ///< [N/m], [N·s/m], [N]
};
SpringConstants spring_constants(const WorldState& world, const Grab& grab);
/// Returns the grab as frames show it.
std::optional<GrabView> grab_view(const WorldState& world);
/// Adds a force [N] on a grabbed point to its corners and, in a quadratic tet, to its edges.
void add_force_at(const WorldState& world, const Grab& grab, const Vec3& force, ExternalForces& forces);

}  // namespace griffith
