#include "sim/world/conditions/push.h"

#include <vector>

#include "sim/core/error.h"
#include "sim/world/conditions/material_point.h"
#include "sim/world/state/world_state.h"

namespace griffith {

void begin_push(WorldState& world, const Push& push) {
  const MaterialPoint point = place_point(world, "push", push.tet, push.weights);
  if (!push.impulse.allFinite()) throw InputError("push", "has an impulse that is not finite", "use finite components");
  wake_at(world, point);
  const double time_step = world.model->scene.simulation.time_step;
  PlacedLoad placed{{}, {}, {}, {}, {}, {}};
  placed.load.kind = LoadKind::point_force;
  placed.load.force = push.impulse / time_step;
  placed.load.start = world.time;
  placed.load.duration = time_step;
  placed.point = point;
  world.loads.push_back(std::move(placed));
}

void end_pushes(WorldState& world) {
  const double half_step = world.model->scene.simulation.time_step / 2;
  std::erase_if(world.loads, [&](const PlacedLoad& placed) {
    return placed.is_push() && placed.load.start + half_step < world.time;
  });
}

}  // namespace griffith
