#include "sim/world/impacts/lone_impact.h"

#include <algorithm>
#include <limits>
#include <utility>

#include "sim/world/bodies/impact_speeds.h"
#include "sim/world/contact/contact_phase.h"
#include "sim/world/energy/energy_phase.h"
#include "sim/world/explicit/explicit_obstacles.h"
#include "sim/world/explicit/explicit_regime.h"
#include "sim/world/explicit/explicit_run.h"
#include "sim/world/explicit/similarity.h"
#include "sim/world/regime/regime_change.h"

namespace griffith {
namespace {

/// Group of the bodies whose waves are followed alone.
constexpr int kAlone = 1;

/// Returns the energy of a body in the field of gravity, except for a constant [J].
double energy_in_flight(const WorldState& world, const Body& body) {
  return energy_of(world, body) - body.motion.mass * world.model->scene.gravity.dot(body.motion.center);
}

/// State of the shared microsteps, which those of a lone impact leave unchanged.
class SharedMicrosteps {
 public:
  SharedMicrosteps(WorldState& world, double time)
      : world_(world),
        time_(std::exchange(world.time, time)),
        check_(std::exchange(world.overload_check, OverloadHistory::kNever)),
        work_(world.scratch.microstep_work),
        overhead_(world.explicit_overhead),
        microsteps_(world.report.microsteps) {}
  ~SharedMicrosteps() {
    world_.time = time_, world_.overload_check = check_;
    world_.scratch.microstep_work = work_, world_.explicit_overhead = overhead_;
    world_.report.microsteps = microsteps_;
  }
  SharedMicrosteps(const SharedMicrosteps&) = delete;
  SharedMicrosteps& operator=(const SharedMicrosteps&) = delete;

  double work_since() const { return world_.scratch.microstep_work - work_; }
  int microsteps_since() const { return world_.report.microsteps - microsteps_; }

 private:
  WorldState& world_;
  double time_, check_, work_, overhead_;
  int microsteps_;
};

/// Takes the bodies of an impact to where they touch; those that deform are in explicit dynamics then.
void bring_together(WorldState& world, const Impact& impact, const Flights& flights, double contact) {
  for (int i = 0; i < 2; ++i) {
    if (!impact.bodies[i].valid()) continue;
    Body& body = world.bodies[impact.bodies[i]];
    world.contact_world.wake_up(body.proxy);
    body.asleep = false;
    fly(world, body, flights[i] + contact);
    if (!impact.deforms[i]) continue;
    begin_explicit(world, body, impact.met.approach);
    body.explicit_state->group = kAlone;
  }
  place_proxies(world);
}

/// Returns the obstacles of the bodies that deform: the other one and the ground.
std::vector<explicit_dynamics::Obstacle> obstacles_of(const WorldState& world, const Impact& impact) {
  double spacing = std::numeric_limits<double>::infinity();
  for (int i = 0; i < 2; ++i)
    if (impact.deforms[i]) spacing = std::min(spacing, world.bodies[impact.bodies[i]].element_size);
  std::vector<explicit_dynamics::Obstacle> obstacles;
  add_ground(world, obstacles);
  for (int i = 0; i < 2; ++i)
    if (!impact.deforms[i] && impact.bodies[i].valid())
      obstacles.push_back(
          obstacle_of(world, world.bodies[impact.bodies[i]], world.contact_world.state(impact.objects()[i]), spacing));
  return obstacles;
}

/// Makes a body rigid whose waves were followed for `time` [s].
void hand_back(WorldState& world, Body& body, double time) {
  end_explicit(world, body);
  stop_vibration(world, body);
  const double before = kinetic_energy(body.motion);
  body.motion.velocity -= time * world.model->scene.gravity;  // all of which the step will give
  place_rigid_nodes(body, world.nodes, world.edges);
  world.energy.time_integration += before - kinetic_energy(body.motion);
}

}  // namespace

void fly(WorldState& world, Body& body, double time) {
  if (body.asleep || body.supported()) return;
  const double before = energy_in_flight(world, body);
  place_body(world, body, flown(world, body.proxy, proxy_state(world, body), time));
  world.energy.time_integration += before - energy_in_flight(world, body);
}

Followed follow_impact(WorldState& world, const Impact& impact, const Flights& flights, double contact) {
  const double until_contact = impact.met.strike + contact;
  const SharedMicrosteps shared(world, world.time + until_contact);
  bring_together(world, impact, flights, contact);
  double window = 0;
  for (int i = 0; i < 2; ++i)
    if (impact.deforms[i]) window = std::max(window, impact_window(world, world.bodies[impact.bodies[i]]));
  std::vector<explicit_dynamics::Obstacle> obstacles = obstacles_of(world, impact);
  const ObstacleAccount account(world, obstacles);
  ExplicitRun run(world, std::move(obstacles), -until_contact, kAlone);
  Followed followed;
  followed.time = run.run_until_quiet(window, world.model->scene.simulation.time_step);
  for (const explicit_dynamics::Obstacle& obstacle : run.obstacles()) place_obstacle(world, obstacle);
  account.record(world, run.obstacles());
  run.finish(followed.time);
  for (int i = 0; i < 2; ++i)
    if (impact.bodies[i].valid() && !impact.deforms[i]) followed.bodies.push_back(impact.bodies[i]);
  for (Body& body : world.bodies) {
    if (!body.explicit_state || body.explicit_state->group != kAlone) continue;
    followed.bodies.push_back(body.id);
    hand_back(world, body, followed.time);
  }
  followed.work = shared.work_since();
  followed.microsteps = shared.microsteps_since();
  return followed;
}

}  // namespace griffith
