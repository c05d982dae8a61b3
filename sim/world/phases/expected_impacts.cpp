#include "sim/world/phases/expected_impacts.h"

#include <algorithm>

#include "sim/world/world_state.h"

namespace griffith {

double time_before_impact(const WorldState& world, double maximum, double tolerance) {
  return world.contact_world.time_before_impact(maximum, min_impact_speed(world), tolerance);
}

// What rests falls by g·dt in every step, and is caught again.
double min_impact_speed(const WorldState& world) {
  return std::max(0.1, 2 * world.model->scene.gravity.norm() * world.model->scene.simulation.time_step);
}

}  // namespace griffith
