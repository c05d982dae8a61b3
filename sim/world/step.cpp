#include <algorithm>
#include <chrono>
#include <limits>
#include <optional>

#include "sim/world/phases.h"
#include "sim/world/shock_phase.h"
#include "sim/world/world.h"
#include "sim/world/world_impl.h"

namespace griffith {
namespace {

/// Adds the milliseconds of its own life to a phase; for display alone.
class PhaseTimer {
 public:
  explicit PhaseTimer(double& milliseconds) : milliseconds_(milliseconds), start_(Clock::now()) {}
  ~PhaseTimer() { milliseconds_ += std::chrono::duration<double, std::milli>(Clock::now() - start_).count(); }

 private:
  using Clock = std::chrono::steady_clock;
  double& milliseconds_;
  Clock::time_point start_;
};

/// Separation and fracture under the stresses there are after a substep of this length [s]; whether it is to be made
/// again.
bool fracture(WorldState& world, double substep, const Attempt& attempt) {
  {
    PhaseTimer timer(world.report.milliseconds.separation);
    evaluate_separation(world, world.scene.analysis == Analysis::dynamic);
  }
  if (!world.scene.simulation.fracture) return false;
  PhaseTimer timer(world.report.milliseconds.fracture);
  return open_cracks(world, substep, attempt);
}

/// Everything but the bodies in shock.
void move_quietly(WorldState& world, double dt) {
  StepTimings& timings = world.report.milliseconds;
  std::vector<Vec3> external;
  {
    PhaseTimer timer(timings.elasticity);
    assemble_systems(world, dt);
    external = external_forces(world);
    predict_velocities(world, external, dt);
  }
  {
    PhaseTimer timer(timings.contact);
    resolve_contacts(world, dt);
  }
  {
    PhaseTimer timer(timings.elasticity);
    move_bodies(world, external, dt);
  }
}

/// Returns whether it is to be made again.
bool substep(WorldState& world, double dt, const Attempt& attempt) {
  move_quietly(world, dt);
  world.time += dt;
  return fracture(world, dt, attempt);
}

void step_explicitly(WorldState& world, double time_step) {
  world.report.substeps = stable_substeps(world, time_step);
  const double dt = time_step / world.report.substeps;
  for (int i = 0; i < world.report.substeps; ++i) substep(world, dt, {});
  calm_bodies(world);
  rest_bodies(world, time_step);
}

/// How far the step may go on in one piece: up to the next impact, or while waves run in the bodies that were struck.
/// These are in shock then.
double next_stretch(WorldState& world, double left) {
  const double time_step = world.scene.simulation.time_step, tolerance = time_step / 512;
  if (!in_shock(world)) {
    const double calm = time_before_impact(world, left, tolerance);
    if (calm > tolerance || calm == left) return calm;
  }
  double window = time_step / 4;
  for (const Body& body : world.bodies)
    if (body.shock) window = std::max(window, shock_window(world, body));
  enter_struck_bodies(world, std::min(left, window));
  if (!in_shock(world)) return left;
  for (const Body& body : world.bodies)
    if (body.shock) window = std::max(window, shock_window(world, body));
  return std::min(left, window);
}

/// Bodies that load has overcome crack as waves let them.
void judge_swaying_bodies(WorldState& world) {
  PhaseTimer timer(world.report.milliseconds.separation);
  evaluate_separation(world, true);
  if (!world.scene.simulation.fracture) return;
  for (Body& body : world.bodies) {
    if (!body.sways()) continue;
    const bool overloaded = std::ranges::any_of(
        body.nodes, [&](NodeId node) { return world.nodes.separations[node].margin > 1; });
    if (overloaded) enter_shock(world, body);
  }
}

void step_dynamically(WorldState& world, double time_step) {
  world.report.substeps = 0;
  for (double left = time_step; left > 1e-9 * time_step; ++world.report.substeps) {
    const double stretch = next_stretch(world, left);
    const bool shock = in_shock(world);
    std::vector<shock::Obstacle> obstacles = shock ? obstacles_of_shock(world, stretch) : std::vector<shock::Obstacle>();
    const double start = world.time;
    move_quietly(world, stretch);
    if (shock) {
      PhaseTimer timer(world.report.milliseconds.shock);
      run_shock(world, std::move(obstacles), stretch);
      place_stand_ins(world);
    }
    world.time = start + stretch;
    left -= stretch;
    leave_shock(world);
    judge_swaying_bodies(world);
  }
  calm_bodies(world);
  rest_bodies(world, time_step);
}

/// Without inertia: from one equilibrium to the next, as loads and supports move on. Each crack changes the balance, so
/// it is found again until nothing more cracks or the budget ends.
void step_statically(WorldState& world, double time_step) {
  const int budget = world.scene.simulation.impact_substeps;
  double displacement_time = time_step;
  world.time += time_step;
  int cracks_before = -1;
  for (world.report.substeps = 0; world.report.cracks > cracks_before; ++world.report.substeps) {
    {
      PhaseTimer timer(world.report.milliseconds.elasticity);
      find_equilibrium(world, world.time, displacement_time, false);
      update_elements(world);
    }
    displacement_time = 0;
    if (world.report.substeps == budget) {
      ++world.report.coarse_substeps;
      return evaluate_separation(world, false);
    }
    cracks_before = world.report.cracks;
    fracture(world, std::numeric_limits<double>::infinity(), {});
  }
}

}  // namespace

void World::step() { advance(impl_->state); }

void advance(WorldState& world) {
  world.report = {};
  world.contact_views.clear();
  for (Body& body : world.bodies) body.softened.reset();
  {
    PhaseTimer timer(world.report.milliseconds.step);
    const double time_step = world.scene.simulation.time_step;
    launch_projectiles(world);
    update_supports(world, world.time, time_step);
    wake_loaded_bodies(world, world.time - time_step, world.time);
    if (world.scene.analysis == Analysis::equilibrium) {
      step_statically(world, time_step);
    } else if (world.integrates_explicitly()) {
      step_explicitly(world, time_step);
    } else {
      step_dynamically(world, time_step);
    }
    ++world.step;
    world.time = static_cast<double>(world.step) * time_step;
  }
  publish(world);
}

}  // namespace griffith
