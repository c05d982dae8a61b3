#pragma once

#include <functional>

#include "sim/core/monitor.h"
#include "sim/world/world_state.h"

namespace griffith {

/// Brings the elastic bodies for which `concerns` holds to rest where what acts on them at `time` [s] is in balance.
/// Prescribed supports go on for `displacement_time` [s]. Free bodies get inertia relief (solve_static()). Throws
/// Cancelled when the monitor says so.
void find_equilibrium(WorldState& world, double time, double displacement_time,
                      const std::function<bool(const Body&)>& concerns, const Monitor& monitor = {});
/// Starts supported bodies in equilibrium, if the scene asks for that: the pieces of `scene_body`, or all (−1). Throws
/// as find_equilibrium() does.
void find_static_start(WorldState& world, int scene_body = -1, const Monitor& monitor = {});

}  // namespace griffith
