#include "sim/world/conditions/quick_changes.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "sim/core/sort_unique.h"
#include "sim/world/bodies/bodies.h"
#include "sim/world/state/world_state.h"

namespace griffith {
namespace {

/// Fraction of the breaking stress that must appear or vanish while a wave crosses the body.
constexpr double kQuickFraction = 0.1;

double wave_speed(const WorldState& world, const Body& body) { return bar_wave_speed(world.material_of(body)); }

/// Returns the approximate stress in a body under a full load [Pa].
double stress_by(const WorldState& world, const PlacedLoad& placed, const Body& body) {
  const Load& load = placed.load;
  const double points = placed.point ? 1 : static_cast<double>(placed.corners.size());
  switch (load.kind) {
    case LoadKind::point_force:
      return load.force.norm() / (points * body.element_size * body.element_size);
    case LoadKind::traction:
      return load.traction.norm();
    case LoadKind::pressure:
      return std::abs(load.pressure);
    case LoadKind::body_force:
      return world.material_of(body).density * load.acceleration.norm() * body.extent;
  }
  return 0;
}

/// True if a change begins before the end of a span and ends at its start or later.
bool touches(const TimeSpan& change, const TimeSpan& span) { return change.from < span.to && change.to >= span.from; }

/// Change of the stress in a body by a changing load while a wave crosses it, approximately [Pa].
struct StressChange {
  TimeSpan time;
  double stress = 0;
};

/// Changes of the stress of bodies.
class Changes {
 public:
  explicit Changes(const WorldState& world) : world_(world), of_bodies_(world.bodies.size()) {}

  void add(const Body& body, const TimeSpan& time, double stress) { of_bodies_[body.id].push_back({time, stress}); }

  /// Returns those that touch a span and are quick, with all others that begin while a wave crosses the body.
  std::vector<QuickChange> quick(const TimeSpan& span) const {
    std::vector<QuickChange> found;
    for (const Body& body : world_.bodies)
      for (const StressChange& change : of_bodies_[body.id])
        if (touches(change.time, span) && is_quick(body, change)) found.push_back({body.id, change.time});
    return found;
  }

 private:
  bool is_quick(const Body& body, const StressChange& change) const {
    const double transit = body.extent / wave_speed(world_, body);
    double stress = 0;
    for (const StressChange& other : of_bodies_[body.id])
      if (std::abs(other.time.from - change.time.from) < transit) stress += other.stress;
    return stress >= kQuickFraction * min_breaking_stress(world_, body, false);
  }

  const WorldState& world_;
  std::vector<std::vector<StressChange>> of_bodies_;
};

/// Returns the time span in which a load grows [s].
TimeSpan growth_of(const Load& load) {
  const double full = load.start + load.ramp;
  return {load.start, load.duration ? std::min(full, load.start + *load.duration) : full};
}
double end_of_duration(const Load& load) {
  return load.duration ? load.start + *load.duration : std::numeric_limits<double>::infinity();
}

/// Returns the time at which a prescribed support stops [s].
double stop_of(const Support& support) { return support.stop.value_or(std::numeric_limits<double>::infinity()); }

bool anything_changes(const WorldState& world, const TimeSpan& span) {
  return std::ranges::any_of(world.loads,
                             [&](const PlacedLoad& placed) {
                               return touches(growth_of(placed.load), span) ||
                                      touches(end_of_duration(placed.load), span);
                             }) ||
         std::ranges::any_of(world.supports, [&](const PlacedSupport& placed) {
           return placed.support.kind == SupportKind::prescribed &&
                  (touches(0, span) || touches(stop_of(placed.support), span));
         });
}

/// True if a static start includes a load.
bool is_there_at_start(const WorldState& world, const Load& load, const Body& body) {
  return load_factor(load, 0) == 1 && body.supported() && world.model->scene.simulation.static_start;
}

void add_changes(const WorldState& world, const PlacedLoad& placed, Changes& changes) {
  const Load& load = placed.load;
  const TimeSpan growth = growth_of(load);
  const double reached = load.ramp > 0 ? growth.duration() / load.ramp : 1;
  for (const BodyId id : bodies_under(world, placed)) {
    const Body& body = world.bodies[id];
    const double stress = stress_by(world, placed, body), transit = body.extent / wave_speed(world, body);
    if (!is_there_at_start(world, load, body))
      changes.add(body, growth, load.ramp > transit ? stress * transit / load.ramp : reached * stress);
    if (load.duration) changes.add(body, end_of_duration(load), reached * stress);
  }
}

/// Adds the stress waves ρ c v of a support that starts or stops.
void add_changes(const WorldState& world, const PlacedSupport& placed, Changes& changes) {
  if (placed.support.kind != SupportKind::prescribed) return;
  std::vector<BodyId> held;
  for (const TetCorner& corner : placed.corners) held.push_back(world.elements.bodies[corner.tet]);
  sort_unique(held);
  for (const BodyId id : held) {
    const Body& body = world.bodies[id];
    const double stress = world.material_of(body).density * wave_speed(world, body) * placed.support.velocity.norm();
    changes.add(body, 0, stress);
    if (placed.support.stop) changes.add(body, stop_of(placed.support), stress);
  }
}

}  // namespace

std::vector<QuickChange> quick_changes(const WorldState& world, const TimeSpan& span) {
  if (!anything_changes(world, span)) return {};
  Changes changes(world);
  for (const PlacedLoad& placed : world.loads)
    if (!placed.spring) add_changes(world, placed, changes);
  for (const PlacedSupport& placed : world.supports) add_changes(world, placed, changes);
  return changes.quick(span);
}

bool is_pulsed(const WorldState& world, const Body& body, const TimeSpan& span) {
  std::vector<double> moments;
  for (const QuickChange& change : quick_changes(world, span))
    if (change.body == body.id) moments.push_back(change.time.from);
  sort_unique(moments);
  return moments.size() > 1;
}

}  // namespace griffith
