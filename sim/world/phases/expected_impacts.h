#pragma once

#include <functional>
#include <vector>

#include "sim/world/world_state.h"

namespace griffith {

/// What may strike hard enough to hurt within `duration` [s], of pairs that matter if a filter is given; see
/// ContactWorld::expected_impacts(). Projectiles and the ground have no body.
std::vector<ContactWorld::Encounter> expected_impacts(const WorldState& world, double duration,
                                                      const std::function<bool(BodyId, BodyId)>& matters = {});
/// The time until the first of them, `maximum` where there are none [s].
double time_before(const std::vector<ContactWorld::Encounter>& impacts, double maximum);
/// What is nearer than this counts as now [s].
double impact_tolerance(const WorldState& world);
/// No slower approach is an impact [m/s].
double min_impact_speed(const WorldState& world);

}  // namespace griffith
