#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>
#include <optional>

#include "sim/world/energy_phase.h"
#include "sim/world/phases.h"
#include "sim/world/rewind.h"
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

/// Contacts and motion of everything but the bodies in shock.
void move(WorldState& world, double dt) {
  note_substep_start(world);
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
    soften_struck_bodies(world, dt);
  }
  {
    PhaseTimer timer(timings.elasticity);
    move_bodies(world, external, dt);
  }
}

/// Returns whether it is to be made again.
bool substep(WorldState& world, double dt, const Attempt& attempt) {
  move(world, dt);
  world.time += dt;
  return fracture(world, dt, attempt);
}

/// In equal substeps; where cracks or cuts leave smaller elements, what is left of the step goes on in shorter ones.
void step_explicitly(WorldState& world, double time_step) {
  constexpr double kRounding = 1e-9;
  for (double left = time_step; left > 0; ++world.report.substeps) {
    const double count = std::max(1.0, std::ceil((1 - kRounding) * left / stable_substep(world)));
    const double dt = left / count;
    substep(world, dt, {});
    left = count > 1 ? left - dt : 0;
  }
  calm_bodies(world);
  rest_bodies(world, time_step);
}

/// How many substeps may follow if each costs what the last one did.
int substeps_left(const WorldState& world, double budget, int made) {
  const int most = std::max(1, world.scene.simulation.impact_substeps - made);
  const double expected = least_work(world) + world.work.sum() + world.work.fresh_contacts;
  return static_cast<int>(std::clamp<double>(budget / expected, 1, most));
}

bool may_crack(const WorldState& world) {
  return world.scene.simulation.fracture &&
         std::any_of(world.bodies.begin(), world.bodies.end(), [](const Body& body) { return !body.rigid; });
}

/// A substep of `ticks`, made again while cracks would have run on in it and the budget, which it lessens, lasts.
/// Returns how often it was made.
int substep_with_cracks(WorldState& world, int ticks, bool last, int made, double& budget) {
  const double dt = world.scene.simulation.time_step * ticks / kTicksPerStep;
  for (int attempt = 1;; ++attempt) {
    const bool affordable = substeps_left(world, budget, made + attempt - 1) > (last ? 1 : 2);
    const std::optional<Moment> start = affordable && may_crack(world) ? std::optional(moment_of(world)) : std::nullopt;
    world.work = {};
    const bool again = substep(world, dt, {start ? &*start : nullptr, attempt});
    budget -= least_work(world) + world.work.sum();
    if (again) {
      ++world.report.repeated_substeps;
      continue;
    }
    world.report.coarse_substeps += !affordable && attempt * world.crack_transit_time < dt;
    return attempt;
  }
}

void step_implicitly(WorldState& world, double time_step) {
  double budget = 1e3 * world.scene.simulation.step_budget;
  int made = 0;
  for (int ticks_left = kTicksPerStep; ticks_left > 0;) {
    const int ticks = next_substep(world, ticks_left, substeps_left(world, budget, made));
    made += substep_with_cracks(world, ticks, ticks == ticks_left, made, budget);
    ticks_left -= ticks;
  }
  world.report.substeps = made - world.report.repeated_substeps;
  calm_bodies(world);
  rest_bodies(world, time_step);
}

/// In stretches: up to the next impact, and while waves run in what was struck or cracks. Bodies in shock take
/// microsteps through a stretch, all else one implicit substep.
void step_by_stretches(WorldState& world, double time_step) {
  constexpr double kRounding = 1e-9;
  for (double left = time_step; left > kRounding * time_step; ++world.report.substeps) {
    const double start = world.time, stretch = next_stretch(world, left);
    const std::vector<shock::Obstacle> obstacles = obstacles_of_shock(world, stretch);
    move(world, stretch);
    if (in_shock(world)) {
      PhaseTimer timer(world.report.milliseconds.shock);
      run_shock(world, obstacles, stretch);
      place_stand_ins(world);
    }
    world.time = start + stretch;
    left -= stretch;
    leave_shock(world);
    PhaseTimer timer(world.report.milliseconds.separation);
    evaluate_separation(world, true);
    enter_overloaded_bodies(world);
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
      find_equilibrium(world, world.time, displacement_time, [](const Body&) { return true; });
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
  world.energy_before = world.energy;
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
    } else if (world.scene.simulation.integrator == Integrator::hybrid) {
      world.report.substeps = 0;
      step_by_stretches(world, time_step);
    } else {
      step_implicitly(world, time_step);
    }
    ++world.step;
    world.time = static_cast<double>(world.step) * time_step;
  }
  publish(world);
}

}  // namespace griffith
