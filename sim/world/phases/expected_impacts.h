#pragma once

#include "sim/world/world_state.h"

namespace griffith {

/// The longest time in which nothing strikes hard enough to hurt, up to `maximum` and within `tolerance` [s].
double time_before_impact(const WorldState& world, double maximum, double tolerance);
/// No slower approach is an impact [m/s].
double min_impact_speed(const WorldState& world);

}  // namespace griffith
