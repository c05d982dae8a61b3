#include "sim/world/bodies/expected_impacts.h"

#include <algorithm>

#include "sim/world/state/world_state.h"

namespace griffith {

std::vector<ContactWorld::Encounter> expected_impacts(const WorldState& world, double duration,
                                                      const std::function<bool(BodyId, BodyId)>& matters) {
  ContactWorld::PairFilter filter;
  if (matters) filter = [&](ProxyId a, ProxyId b) { return matters(world.body_of(a), world.body_of(b)); };
  return world.contact_world.expected_impacts(duration, min_impact_speed(world), impact_tolerance(world), filter);
}

double time_before(const std::vector<ContactWorld::Encounter>& impacts, double maximum) {
  double time = maximum;
  for (const ContactWorld::Encounter& impact : impacts) time = std::min(time, impact.time);
  return time;
}

double impact_tolerance(const WorldState& world) { return world.model->scene.simulation.time_step / 512; }

// What rests falls by g·dt in every step, and is caught again.
double min_impact_speed(const WorldState& world) {
  return std::max(0.1, 2 * world.model->scene.gravity.norm() * world.model->scene.simulation.time_step);
}

}  // namespace griffith
