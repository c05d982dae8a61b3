#pragma once

#include <functional>
#include <vector>

#include "sim/world/state/world_state.h"

namespace griffith {

/// Returns the impacts within `duration` [s] that are fast enough to cause damage, only of pairs that matter if a
/// filter is given; see ContactWorld::expected_impacts(). Projectiles and the ground have no body.
std::vector<ContactWorld::Encounter> expected_impacts(const WorldState& world, double duration,
                                                      const std::function<bool(BodyId, BodyId)>& matters = {});
/// Returns the time until the first of them, `maximum` if there are none [s].
double time_before(const std::vector<ContactWorld::Encounter>& impacts, double maximum);
/// Returns the time within which an impact counts as present [s].
double impact_tolerance(const WorldState& world);
/// Returns the least approach speed of an impact [m/s].
double min_impact_speed(const WorldState& world);

}  // namespace griffith
