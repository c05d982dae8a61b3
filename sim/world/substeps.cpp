#include <algorithm>
#include <cmath>

#include "sim/world/phases.h"

namespace griffith {
namespace {

/// Substeps lengthen by this factor once nothing strikes any more.
constexpr double kGrowth = 1.3;
/// A wave crosses an element in this many substeps of the finest kind (stress of an impact within some percent).
constexpr double kSubstepsPerElement = 4;

/// How fine time must be to see the stress of an impact on any body that can break [s].
double finest_impact_substep(const WorldState& world) {
  double length = 1;
  for (const Body& body : world.bodies)
    if (body.tets.size() > 1) length = std::min(length, impact_substep(world, body));
  return length;
}

/// The shortest first one of so many substeps, each longer than the one before, that cover the time; in ticks. An
/// impact's stress rises in its first substeps: the finest are spent there.
int least_substep(int ticks_left, int substeps_left) {
  const double sum = (std::pow(kGrowth, substeps_left) - 1) / (kGrowth - 1);
  return static_cast<int>(std::ceil(ticks_left / sum));
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

double impact_substep(const WorldState& world, const Body& body) {
  return body.element_size / (kSubstepsPerElement * bar_wave_speed(world.material_of(body)));
}

double least_work(const WorldState& world) {
  double work = 0;
  for (const Body& body : world.bodies)
    work += Work::kPerBody + (body.rigid ? 0.0 : Work::kPerTet * static_cast<double>(body.tets.size()));
  return work;
}

int next_substep(WorldState& world, int ticks_left, int substeps_left) {
  const double tick = world.scene.simulation.time_step / kTicksPerStep;
  const int least = least_substep(ticks_left, substeps_left);
  const int impact_ticks = whole_ticks(finest_impact_substep(world), tick),
            crack_ticks = whole_ticks(world.crack_transit_time, tick);
  const int finest = std::max(least, impact_ticks);
  const int grown = std::clamp(static_cast<int>(std::ceil(kGrowth * world.substep_ticks)), finest, kTicksPerStep);
  const int wanted = std::min(grown, std::max(crack_ticks, least));
  const int most = std::min(wanted, ticks_left);
  const int calm = ticks_before_impact(world, tick, least_impact_speed(world), most, finest);
  const bool struck = calm < most;
  world.report.coarse_substeps += least > crack_ticks || (struck && least > impact_ticks);
  // A pause before a strike is no reason to lengthen what follows it.
  world.substep_ticks = struck ? finest : wanted;
  const int ticks = std::min(ticks_left, std::max(calm, finest));
  world.coarse_impact.reset();
  if (struck && calm < finest && ticks > impact_ticks)
    world.coarse_impact = CoarseImpact{ticks * tick, std::min(substeps_left, ticks_left / ticks)};
  return ticks;
}

}  // namespace griffith
