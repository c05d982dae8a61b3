#pragma once

#include "sim/world/energy/energy_phase.h"

namespace griffith {

/// Returns the work of yielding since `before` [J], at the stress now and the fraction `relieved` of that which
/// yielding took away: half of it where a body flows after its motion, none where it flows in equilibrium.
double work_of_yielding(const WorldState& world, const Body& body, const BodySnapshot& before, double relieved);

}  // namespace griffith
