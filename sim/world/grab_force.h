#pragma once

/// Force of a grab: a load on a point of material (PlacedLoad::spring) by a spring and a damper to a target. It is
/// constant in a substep,
///   f⁺ = f + (k (t − x − h v) − c v − f) / (1 + h (h k + c) w),   |f⁺| ≤ f_max,
/// with the target t, the point's position x and velocity v, and its admittance w, the velocity per impulse along the
/// change of force. So the spring is implicit in what it moves by that change alone: stiff springs are stable, and in
/// equilibrium, whatever else acts, f = k (t − x). Stiffness k = m ω², damping c = 2 ζ m ω and f_max are those of the
/// piece that the point belongs to now. The target rests between its moves; the damper resists the motion of the point.
namespace griffith {

struct WorldState;

/// Sets the force of the grab, if there is one, for the next substep of `dt` [s], after systems are assembled.
void update_grab(WorldState& world, double dt);

}  // namespace griffith
