#include <chrono>

#include "sim/world/phases.h"
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

void substep(WorldState& world, double dt) {
  StepTimings& timings = world.report.milliseconds;
  std::vector<Vec3> external_forces;
  {
    PhaseTimer timer(timings.elasticity);
    assemble_systems(world, dt);
  }
  {
    PhaseTimer timer(timings.contact);
    external_forces = contact_forces(world, dt);
  }
  {
    PhaseTimer timer(timings.elasticity);
    advance_bodies(world, external_forces, dt);
    update_elements(world);
  }
  if (!world.scene.simulation.fracture) return;
  {
    PhaseTimer timer(timings.separation);
    evaluate_separation(world);
  }
  {
    PhaseTimer timer(timings.fracture);
    open_cracks(world);
  }
}

}  // namespace

void World::step() {
  WorldState& world = impl_->state;
  world.report = {};
  {
    PhaseTimer timer(world.report.milliseconds.step);
    launch_projectiles(world);
    const double time_step = world.scene.simulation.time_step;
    const int budget = substep_budget(world);
    int substeps = 0;
    for (int ticks_left = kTicksPerStep; ticks_left > 0; ++substeps) {
      const int ticks = next_substep(world, ticks_left, budget - substeps);
      substep(world, time_step * ticks / kTicksPerStep);
      ticks_left -= ticks;
    }
    world.report.substeps = substeps;
    calm_bodies(world);
    ++world.step;
    world.time = static_cast<double>(world.step) * time_step;
  }
  publish(world);
}

}  // namespace griffith
