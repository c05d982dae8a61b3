#pragma once

#include <functional>

#include "sim/core/monitor.h"
#include "sim/world/state/world_state.h"

namespace griffith {

/// Brings the elastic bodies for which `concerns` returns true to equilibrium with the loads at `time` [s]. Prescribed
/// supports move on for `displacement_time` [s]. Free bodies get inertia relief (solve_static()). Throws Cancelled if
/// the monitor requests it.
void find_equilibrium(WorldState& world, double time, double displacement_time,
                      const std::function<bool(const Body&)>& concerns, const Monitor& monitor = {});
/// Starts supported bodies in equilibrium if the scene requests it: the pieces of `scene_body`, or all (−1). Throws as
/// find_equilibrium() does.
void find_static_start(WorldState& world, int scene_body = -1, const Monitor& monitor = {});

}  // namespace griffith
