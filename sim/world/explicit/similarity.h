#pragma once

#include "sim/elasticity/element_frequency.h"
#include "sim/world/world_state.h"

/// Dynamic similarity of bodies in explicit dynamics, for impacts that would take more microsteps than the budget
/// leaves. With
///   E′ = f² E,  σ_t′ = f σ_t,  K_Ic′ = f K_Ic
/// at equal density and speed of impact, stresses are σ′ = f σ, and cracks go the same way 1/f times slower, in as many
/// microsteps 1/f times longer. It holds for as long as the impact is slow against the slowed waves.
namespace griffith {

/// A body's elasticity as its stress follows from its strain now: that of the material times f, so that stress counts
/// against the full strength.
ElasticLaw effective_elastic_law(const WorldState& world, const Body& body);

/// Highest frequency that elements of the body keep under the full stiffness, slivers relieved [rad/s].
double highest_frequency(const WorldState& world, const Body& body);

/// Gives a body in explicit dynamics, which may be a piece by now, the frequency that belongs to its elements.
void limit_frequency(const WorldState& world, Body& body);

/// Lessens f of bodies in explicit dynamics where what is to be followed of explicit dynamics would exceed the budget,
/// `left` [s] before the end of the step.
void choose_similarity(WorldState& world, double left);

/// Takes a body in explicit dynamics to another f. Stress, energy and motion stay.
void set_similarity(WorldState& world, Body& body, double factor);

/// Gives a body that leaves explicit dynamics the shape that belongs to its stress under the full stiffness. Momentum
/// stays, and the places of supports. A body that this would strain, as one whose halves have turned on a crack, keeps
/// the shape that it has, as if it had yielded.
void end_similarity(WorldState& world, Body& body);

/// How fast a body's nodes move against its center, spinning or deforming, at most [m/s].
double inner_speed(const WorldState& world, const Body& body);

/// The bar wave's speed in a body in explicit dynamics, as it is slowed now [m/s].
double slowed_wave_speed(const WorldState& world, const Body& body);

/// How long a wave takes to cross an element of the body as it is slowed now [s].
double element_transit_time(const WorldState& world, const Body& body);

/// What a microstep of one tet costs, in microseconds of a usual core: counted, not timed, so that a step does the same
/// on every machine.
inline constexpr double kMicrostepWork = 0.03;
/// What a microstep of a quadratic tet costs over that of a linear one [-].
inline constexpr double kQuadraticWork = 4;

/// For how long waves are followed after the last impact or crack: until they would have crossed the whole scene body
/// some times [s].
double explicit_window(const WorldState& world, const Body& body);

/// The same of an impact that is judged or followed by itself, under the full stiffness: until waves would have crossed
/// the body, which may be a piece, as often [s].
double impact_window(const WorldState& world, const Body& body);

/// Until the waves of all bodies in explicit dynamics have been followed, if nothing new happens; 0 without any [s].
double time_to_follow(const WorldState& world);

/// Work that microsteps may still do in this step, at most 20 times its budget or 50 ms [µs of a usual core].
double work_left(const WorldState& world);

/// Whether microsteps have done all that they may in this step: work, or 10,000 of them a millisecond of the budget.
/// What rattles for ever between others, far faster than the step, would never end.
bool is_spent(const WorldState& world);

/// Work that the microsteps of a substep of this length [s] are expected to take [µs of a usual core].
double expected_work(const WorldState& world, double substep);

/// How long the next substep is of a step that has `left` [s] to go: until waves have been followed, but not too short,
/// as each begins with contacts and with what the microsteps know of the bodies. Where impacts prolong explicit
/// dynamics, it is as long as all before, or takes as much work as those of the last step did: heaps rattle on [s].
double planned_substep(const WorldState& world, double left);

}  // namespace griffith
