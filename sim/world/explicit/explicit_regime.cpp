#include "sim/world/explicit/explicit_regime.h"

#include <algorithm>

#include "sim/world/bodies/bodies.h"
#include "sim/world/bodies/impact_speeds.h"
#include "sim/world/energy/energy_phase.h"
#include "sim/world/explicit/body_frequency.h"
#include "sim/world/explicit/explicit_obstacles.h"
#include "sim/world/explicit/explicit_run.h"
#include "sim/world/explicit/similarity.h"
#include "sim/world/fracture/separation_phase.h"
#include "sim/world/motion/elastic_phase.h"
#include "sim/world/regime/regime_change.h"
#include "sim/world/regime/torn_bonds.h"
#include "sim/world/state/world_state.h"

namespace griffith {

bool any_explicit(const WorldState& world) {
  return std::ranges::any_of(world.bodies, [](const Body& body) { return body.explicit_state.has_value(); });
}

void begin_explicit(WorldState& world, Body& body, double impact_speed) {
  if (body.explicit_state || body.tets.size() == 1) return;
  if (body.rigid) place_rigid_nodes(body, world.nodes, world.edges);
  if (body.rigid || body.asleep) make_elastic(world, body);
  world.elements.allow_strains();
  for (const NodeId node : body.nodes) world.nodes.overloads[node].last = OverloadHistory::kNever;
  if (impact_speed > 0) ++world.report.impacts;
  body.explicit_state = ExplicitState{world.time, impact_speed, highest_frequency(world, body)};
}

namespace {

/// Makes a piece rigid that waves have crossed without damage, until the next impact: its remaining vibration is damped
/// at once.
void make_rigid_if_unharmed(WorldState& world, Body& body) {
  // Of the resistance: what contacts must exceed to make it elastic again. Residual stress loads a piece without any.
  constexpr double kUnharmed = 0.25, kUnharmedUnderResidualStress = 0.85;
  const bool has_residual_stress = world.model->scene.bodies[body.scene_body].residual_stress.has_value();
  const auto swings_visibly = [&] {
    return !all_slower(world, body, motion_of(world, body), visible_speed(world, body));
  };
  if (sags_visibly(world, body) || (!has_residual_stress && swings_visibly())) return;
  evaluate_separation(world, body);
  const double limit = has_residual_stress ? kUnharmedUnderResidualStress : kUnharmed;
  const auto is_unharmed = [&](NodeId node) { return world.nodes.separations[node].utilization < limit; };
  if (std::ranges::all_of(body.nodes, is_unharmed)) stop_vibration(world, body);
}

/// Makes a body rigid whose waves have died down, if it may be.
void settle(WorldState& world, Body& body, bool strained) {
  if (!body.supported() && body.bonded) {
    stop_vibration(world, body);  // its bonds hold, but do not act in implicit steps
  } else if (!body.supported() && !strained) {
    make_rigid_if_unharmed(world, body);
  }
  if (body.is_deformable()) follow_deformation(world, body);
}

}  // namespace

void end_explicit(WorldState& world, Body& body) {
  end_similarity(world, body);
  body.explicit_state.reset();
  body.explicit_ended = world.time;
  body.depth = depth_of(world, body);
  world.contact_world.set_impact_speed(body.proxy, examined_impact_speed(world, body));  // cracks may have begun in it
}

bool run_explicit(WorldState& world, std::vector<explicit_dynamics::Obstacle> obstacles, double duration,
                  double max_work) {
  read_back_velocities(world, obstacles);
  const ObstacleAccount account(world, obstacles);
  ExplicitRun run(world, std::move(obstacles), duration);
  if (!run.run(duration, max_work)) return false;
  for (const explicit_dynamics::Obstacle& obstacle : run.obstacles()) place_obstacle(world, obstacle);
  account.record(world, run.obstacles());
  run.finish(duration);
  return true;
}

void end_explicit_if_quiet(WorldState& world) {
  constexpr double kRounding = 1e-9;
  std::vector<BodyId> ended;
  for (Body& body : world.bodies) {
    if (!body.explicit_state) continue;
    const double window = explicit_window(world, body);
    if (world.time - body.explicit_state->last_event < (1 - kRounding) * window) continue;
    end_explicit(world, body);
    ended.push_back(body.id);
  }
  if (ended.empty()) return;
  const std::vector<BodyId> pieces = part_at_torn_bonds(world, ended);
  const std::vector<bool> strained = strained_bodies(world, world.time);
  for (const BodyId id : pieces) settle(world, world.bodies[id], strained[id]);
}

}  // namespace griffith
