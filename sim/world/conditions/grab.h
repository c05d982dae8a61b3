#pragma once

#include <optional>

#include "sim/world/conditions/loads.h"
#include "sim/world/output/frame.h"

namespace griffith {

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
/// Constants of the spring for the piece that it holds now.
struct SpringConstants {
  double stiffness = 0, damping = 0, max_force = 0;  ///< [N/m], [N·s/m], [N]
};
SpringConstants spring_constants(const WorldState& world, const PlacedLoad& grab);
/// Returns the grab as frames show it.
std::optional<GrabView> grab_view(const WorldState& world);

}  // namespace griffith
