#pragma once

#include "sim/world/explicit/struck_bodies.h"

namespace griffith {

/// How far the two things of an impact fly on before they are as near as they were seen to come [s].
using Flights = std::array<double, 2>;

/// Where a body is after flying freely for a time [s], by its motion as a whole: sleepers and supported ones stay.
/// Gravity is left to the step.
RigidState flown(const Body& body, double time);

/// What following an impact by microsteps is expected to take [µs of a usual core].
double expected_work(const WorldState& world, const Impact& impact);

/// What the waves of an impact do to two things that meet.
struct TrialOutcome {
  bool touched = false;  ///< they did meet
  bool harmful = false;  ///< a node may have opened
  double contact = 0;    ///< from the end of their flights until they touched [s]
  double work = 0;       ///< [µs of a usual core]
};

/// Follows an impact by microsteps, without cracks and apart from the world: the bodies that deform start without
/// stress, all else about them is left away. On the safe side: harmless means that no node opens. That takes a largest
/// principal stress in an element at the node above what the node resists, for as long as overload must last; what the
/// node bears already counts against it (the largest principal stress of a sum is no more than the sum of both).
TrialOutcome try_impact(const WorldState& world, const Impact& impact, const Flights& flights);

}  // namespace griffith
