#pragma once

#include "sim/world/state/world_state.h"

/// Dynamic similarity of bodies in explicit dynamics, for impacts that would take more microsteps than the budget
/// leaves. With
///   E′ = f² E,  σ_t′ = f σ_t,  K_Ic′ = f K_Ic
/// at equal density and speed of impact, stresses are σ′ = f σ, and cracks go the same way 1/f times slower, in as many
/// microsteps 1/f times longer. It holds for as long as the impact is slow against the slowed waves.
namespace griffith {

/// Reduces f of bodies in explicit dynamics if the microsteps to be made would exceed the budget,
/// `left` [s] before the end of the step.
void choose_similarity(WorldState& world, double left);

/// Takes a body in explicit dynamics to another f. Stress, energy and motion stay.
void set_similarity(WorldState& world, Body& body, double factor);

/// Sets the shape of a body at the end of explicit dynamics to that of its stress under the full stiffness. Keeps
/// momentum and the places of supports. A body that would gain energy, such as one whose halves have rotated about a
/// crack, keeps its shape as if it had yielded.
void end_similarity(WorldState& world, Body& body);

/// Returns the highest speed of a body's nodes relative to its center, by rotation or deformation [m/s].
double inner_speed(const WorldState& world, const Body& body);

/// Returns the slowed speed of the bar wave in a body in explicit dynamics [m/s].
double slowed_wave_speed(const WorldState& world, const Body& body);

/// Returns the time in which a slowed wave crosses an element of the body [s].
double element_transit_time(const WorldState& world, const Body& body);

/// Work of a microstep of one tet, in microseconds of a typical core: counted, not timed, so that a step is the same on
/// every machine.
inline constexpr double kMicrostepWork = 0.03;
/// Work of a microstep of a quadratic tet relative to a linear one [-].
inline constexpr double kQuadraticWork = 3;

/// Returns the time for which waves are followed after the last impact or crack of a body, which may be a piece: that
/// of several crossings [s].
double explicit_window(const WorldState& world, const Body& body);

/// Returns the time until the waves of all bodies in explicit dynamics have been followed, without new events; 0
/// without such bodies [s].
double time_to_follow(const WorldState& world);

/// Returns the work that microsteps may still take in this step, at most 20 times its budget or 50 ms [µs of a typical
/// core].
double work_left(const WorldState& world);

/// True if microsteps have used up their limit in this step: its work, or 10,000 of them per millisecond of the budget.
/// Objects that rattle between others, far faster than the step, would never finish.
bool is_spent(const WorldState& world);

/// Returns the expected work of the microsteps of a substep of this length [s] [µs of a typical core].
double expected_work(const WorldState& world, double substep);

/// Returns the length of the next substep of a step with `left` [s] to go [s]: until waves have been followed, but not
/// too short, since each substep begins with contacts and the setup of the microsteps. If impacts prolong explicit
/// dynamics, as in heaps, it is as long as all before together, or takes as much work as those of the last step.
double planned_substep(const WorldState& world, double left);

}  // namespace griffith
