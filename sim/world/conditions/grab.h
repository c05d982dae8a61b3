#pragma once

#include <optional>

#include "sim/world/conditions/loads.h"
#include "sim/world/output/frame.h"

/// Grab of a piece: a load on a point of material (PlacedLoad::held) by a spring and a damper to a target. Its force is
/// constant in a substep,
///   f⁺ = f + (k (t − x − h v) − c v − f) / (1 + h (h k + c) w),   |f⁺| ≤ f_max,
/// with the target t, the point's position x and velocity v, and its admittance w, the velocity per impulse along the
/// change of force. So the spring is implicit in what it moves by that change alone: stiff springs are stable, and in
/// equilibrium, whatever else acts, f = k (t − x). Stiffness k = m ω², damping c = 2 ζ m ω and f_max are those of the
/// piece that the point belongs to now. The target rests between its moves; the damper resists the motion of the point.
namespace griffith {

struct WorldState;

/// Begins a grab, in place of the present one if there is one, and wakes the piece. Throws InputError if the point does
/// not exist or the scene has no motion.
void begin_grab(WorldState& world, const Grab& grab);
/// Sets the target [m]. Throws InputError if nothing is grabbed or it is not finite.
void move_grab(WorldState& world, const Vec3& target);
/// Ends the grab, if there is one.
void end_grab(WorldState& world);

/// Sets the force of the grab for the next substep of `dt` [s], after systems are assembled.
void update_grab(WorldState& world, double dt);

/// Returns the grab as frames show it.
std::optional<GrabView> grab_view(const WorldState& world);
/// Adds a force [N] on a grabbed point to its corners and, in a quadratic tet, to its edges.
void add_force_at(const WorldState& world, const Grab& grab, const Vec3& force, ExternalForces& forces);
/// Follows the point of a grab in a tet that was divided into `parts`.
void follow_parts(const WorldState& world, std::span<const TetId> parts, HeldPoint& held);

}  // namespace griffith
