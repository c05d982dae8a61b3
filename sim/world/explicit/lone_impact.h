#pragma once

#include <vector>

#include "sim/world/explicit/impact_trial.h"

namespace griffith {

/// What came of an impact that was followed alone.
struct Followed {
  double time = 0;             ///< that its waves were followed [s]
  std::vector<BodyId> bodies;  ///< that are ahead by it: what met, and its pieces
  double work = 0;             ///< [µs of a usual core]
  int microsteps = 0;
};

/// Takes the two things of an impact to where they touch, `contact` [s] after their flights, through microsteps until
/// their waves have died out, and back to the world, in one piece each or in many, which move as a whole. All else
/// stays as it is. Momentum is that of before, gravity being left to the step; what the energy changes by is booked.
Followed follow_impact(WorldState& world, const Impact& impact, const Flights& flights, double contact);

/// Moves a free body that is awake on as if nothing touched it, or back [s].
void fly(WorldState& world, Body& body, double time);

}  // namespace griffith
