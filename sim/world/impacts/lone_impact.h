#pragma once

#include <vector>

#include "sim/world/impacts/impact_trial.h"

namespace griffith {

/// Result of an impact that was followed alone.
struct Followed {
  double time = 0;             ///< duration of its waves [s]
  std::vector<BodyId> bodies;  ///< bodies that are ahead by it: those that met, and their pieces
  double work = 0;             ///< [µs of a typical core]
  int microsteps = 0;
};

/// Moves the two objects of an impact to their contact, `contact` [s] after their flights, then through microsteps
/// until their waves have died out, and back to the world, in one piece each or in many, which move as a whole. All
/// other objects are unchanged. Momentum is conserved, gravity being left to the step; changes of energy are accounted
/// for.
Followed follow_impact(WorldState& world, const Impact& impact, const Flights& flights, double contact);

/// Moves a free body that is awake on as if nothing touched it, or back [s].
void fly(WorldState& world, Body& body, double time);

}  // namespace griffith
