#include <algorithm>

#include "sim/world/phases.h"

namespace griffith {

double time_before_impact(const WorldState& world, double most, double tolerance) {
  const double speed = least_impact_speed(world);
  if (!world.contact_world.impact_expected(most, speed)) return most;
  double calm = 0, struck = most;
  while (struck - calm > tolerance) {
    const double middle = 0.5 * (calm + struck);
    (world.contact_world.impact_expected(middle, speed) ? struck : calm) = middle;
  }
  return calm;
}

// What rests falls by g·dt in every step, and is caught again.
double least_impact_speed(const WorldState& world) {
  return std::max(0.1, 2 * world.scene.gravity.norm() * world.scene.simulation.time_step);
}

}  // namespace griffith
