#pragma once

#include "sim/world/impacts/struck_bodies.h"

namespace griffith {

/// Times for which the two objects of an impact fly on until they are as close as predicted [s].
using Flights = std::array<double, 2>;

/// Returns the states of the two objects of an impact after these flights.
std::array<RigidState, 2> flown(const WorldState& world, const Impact& impact, const Flights& flights);
/// Returns the state of an object after flight for a time [s] from another state, by its motion as a whole. Sleepers
/// stay. Gravity is left to the step.
RigidState flown(const WorldState& world, ProxyId object, const RigidState& start, double time);

/// Returns the expected work of following an impact by microsteps [µs of a typical core].
double expected_work(const WorldState& world, const Impact& impact);

/// Effect of the waves of an impact on two objects that meet.
struct TrialOutcome {
  bool touched = false;  ///< they did meet
  bool harmful = false;  ///< a node may have opened
  double contact = 0;    ///< time from the end of their flights to their contact [s]
  double work = 0;       ///< [µs of a typical core]
};

/// Follows an impact by microsteps, without cracks and apart from the world: the bodies that deform start without
/// stress, all their surroundings are omitted. Conservative: a result that is not harmful means that no node separates.
/// A harmful one requires a largest principal stress in an element at the node above its resistance, for the duration
/// of an overload; the present load of the node counts against the resistance (the largest principal stress of a sum is
/// at most the sum of both). `states`: of the two objects where they are as close as predicted.
TrialOutcome try_impact(const WorldState& world, const Impact& impact, const std::array<RigidState, 2>& states,
                        double longest_wait = 0);

}  // namespace griffith
