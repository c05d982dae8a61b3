#include <algorithm>

#include "sim/world/phases.h"

namespace griffith {

double time_before_impact(const WorldState& world, double most, double tolerance) {
  return world.contact_world.time_before_impact(most, least_impact_speed(world), tolerance);
}

// What rests falls by g·dt in every step, and is caught again.
double least_impact_speed(const WorldState& world) {
  return std::max(0.1, 2 * world.model->scene.gravity.norm() * world.model->scene.simulation.time_step);
}

}  // namespace griffith
