#include <algorithm>
#include <cmath>

#include "sim/world/phases.h"

namespace griffith {
namespace {

/// A share of the breaking speed sigma_t / (rho c): slower meetings cannot hurt and need no finer time.
constexpr double kShareOfBreakingSpeed = 0.5;
/// Substeps lengthen by this factor once nothing strikes any more.
constexpr double kGrowth = 1.3;
/// A wave crosses an element in this many substeps of the finest kind (stress of an impact within some percent).
constexpr double kSubstepsPerElement = 4;

/// What matters about an impact: the speed from which it can hurt, and how fine time must be to see its stress.
struct ImpactScale {
  double speed = 5;    ///< [m/s]
  double length = 1;   ///< of a substep [s]
};

ImpactScale impact_scale(const WorldState& world) {
  ImpactScale scale;
  for (const Body& body : world.bodies) {
    if (body.rigid) continue;
    const Material& material = world.material_of(body);
    const double wave_speed = bar_wave_speed(material);
    scale.speed = std::min(scale.speed, kShareOfBreakingSpeed * material.tensile_strength / (material.density * wave_speed));
    scale.length = std::min(scale.length, mean_element_size(world, body) / (kSubstepsPerElement * wave_speed));
  }
  // What rests falls by g·dt in every step, and is caught again.
  const double resting = 2 * world.scene.gravity.norm() * world.scene.simulation.time_step;
  scale.speed = std::max({scale.speed, resting, 0.1});
  return scale;
}

int whole_ticks(double time, double tick) {
  return static_cast<int>(std::clamp(time / tick, 1.0, static_cast<double>(kTicksPerStep)));
}

/// The longest time, in ticks, in which nothing strikes, up to `most` and within `tolerance`.
int ticks_before_impact(const WorldState& world, double tick, double speed, int most, int tolerance) {
  if (!world.contact_world.impact_expected(most * tick, speed)) return most;
  int calm = 0, struck = most;
  while (struck - calm > tolerance) {
    const int middle = (calm + struck) / 2;
    (world.contact_world.impact_expected(middle * tick, speed) ? struck : calm) = middle;
  }
  return calm;
}

}  // namespace

int substep_budget(const WorldState& world) {
  constexpr double kWorkPerStep = 13'000;                   // elements times substeps
  constexpr double kWorkPerBody = 20, kWorkPerContact = 10; // in elements
  double work = kWorkPerContact * world.contacts_before;
  for (const Body& body : world.bodies) work += kWorkPerBody + (body.rigid ? 0.0 : static_cast<double>(body.tets.size()));
  return std::clamp(static_cast<int>(kWorkPerStep / work), 1, world.scene.simulation.impact_substeps);
}

int next_substep(WorldState& world, int ticks_left, int substeps_left) {
  const double tick = world.scene.simulation.time_step / kTicksPerStep;
  const ImpactScale scale = impact_scale(world);
  const int least = (ticks_left + substeps_left - 1) / substeps_left;
  const int impact_ticks = whole_ticks(scale.length, tick), crack_ticks = whole_ticks(world.crack_transit_time, tick);
  const int finest = std::max(least, impact_ticks);
  const int grown = std::clamp(static_cast<int>(std::ceil(kGrowth * world.substep_ticks)), finest, kTicksPerStep);
  const int wanted = std::min(grown, std::max(crack_ticks, least));
  const int most = std::min(wanted, ticks_left);
  const int calm = ticks_before_impact(world, tick, scale.speed, most, finest);
  const bool struck = calm < most;
  world.report.coarse_substeps += least > crack_ticks || (struck && least > impact_ticks);
  // A pause before a strike is no reason to lengthen what follows it.
  world.substep_ticks = struck ? finest : wanted;
  return std::min(ticks_left, std::max(calm, finest));
}

}  // namespace griffith
