#include <algorithm>

#include "sim/world/phases.h"

namespace griffith {

void queue_burst(WorldState& world, const ProjectileBurst& burst) {
  for (int i = 0; i < burst.count; ++i)
    world.pending_shots.push_back({world.time + burst.start + i * burst.interval, burst});
  std::stable_sort(world.pending_shots.begin(), world.pending_shots.end(),
                   [](const PendingShot& a, const PendingShot& b) { return a.time < b.time; });
}

void launch_projectiles(WorldState& world) {
  const double rounding = 1e-6 * world.scene.simulation.time_step;
  while (!world.pending_shots.empty() && world.pending_shots.front().time <= world.time + rounding) {
    const ProjectileBurst& burst = world.pending_shots.front().burst;
    RigidState state;
    state.pose.translation = burst.position;
    state.velocity = burst.speed * burst.direction.normalized();
    const ProxyId object = world.contact_world.add_sphere(burst.radius, burst.mass, state, {});
    world.projectiles.push_back({object, burst.radius, burst.mass});
    world.pending_shots.erase(world.pending_shots.begin());
  }
}

}  // namespace griffith
