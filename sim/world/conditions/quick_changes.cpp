#include "sim/world/conditions/quick_changes.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "sim/core/sort_unique.h"
#include "sim/world/bodies/bodies.h"
#include "sim/world/world_state.h"

namespace griffith {
namespace {

/// What of the breaking stress must come or go while a wave crosses the body.
constexpr double kQuickFraction = 0.1;

double wave_speed(const WorldState& world, const Body& body) { return bar_wave_speed(world.material_of(body)); }

/// About the stress in a body under all of a load [Pa].
double stress_by(const WorldState& world, const PlacedLoad& placed, const Body& body) {
  const Load& load = placed.load;
  switch (load.kind) {
    case LoadKind::point_force:
      return load.force.norm() / (static_cast<double>(placed.corners.size()) * body.element_size * body.element_size);
    case LoadKind::traction:
      return load.traction.norm();
    case LoadKind::pressure:
      return std::abs(load.pressure);
    case LoadKind::body_force:
      return world.material_of(body).density * load.acceleration.norm() * body.extent;
  }
  return 0;
}

bool is_quick(const WorldState& world, const Body& body, double stress) {
  return stress >= kQuickFraction * min_breaking_stress(world, body, false);
}

/// Collects the changes that touch a span.
class Changes {
 public:
  Changes(const WorldState& world, const TimeSpan& span) : world_(world), span_(span) {}

  bool touches(const TimeSpan& time) const { return time.from < span_.to && time.to >= span_.from; }
  void add(const Body& body, const TimeSpan& time, double stress) {
    if (touches(time) && is_quick(world_, body, stress)) found_.push_back({body.id, time});
  }
  std::vector<QuickChange> found() { return std::move(found_); }

 private:
  const WorldState& world_;
  const TimeSpan& span_;
  std::vector<QuickChange> found_;
};

/// A static start knows the loads that act from the first.
bool is_there_at_start(const WorldState& world, const Load& load, const Body& body) {
  return load_factor(load, 0) == 1 && body.supported() && world.model->scene.simulation.static_start;
}

void add_changes(const WorldState& world, const PlacedLoad& placed, Changes& changes) {
  const Load& load = placed.load;
  const double end = load.duration ? load.start + *load.duration : std::numeric_limits<double>::infinity();
  const TimeSpan growth(load.start, std::min(load.start + load.ramp, end));
  if (!changes.touches(growth) && !changes.touches(end)) return;
  const double reached = load.ramp > 0 ? growth.duration() / load.ramp : 1;
  for (const BodyId id : bodies_under(world, placed)) {
    const Body& body = world.bodies[id];
    const double stress = stress_by(world, placed, body), transit = body.extent / wave_speed(world, body);
    if (!is_there_at_start(world, load, body))
      changes.add(body, growth, load.ramp > transit ? stress * transit / load.ramp : reached * stress);
    changes.add(body, end, reached * stress);
  }
}

/// A support that starts or stops sends a wave of stress ρ c v into the body.
void add_changes(const WorldState& world, const PlacedSupport& placed, Changes& changes) {
  const Support& support = placed.support;
  if (support.kind != SupportKind::prescribed) return;
  const TimeSpan stop = support.stop.value_or(std::numeric_limits<double>::infinity());
  if (!changes.touches(0) && !changes.touches(stop)) return;
  std::vector<BodyId> held;
  for (const TetCorner& corner : placed.corners) held.push_back(world.elements.bodies[corner.tet]);
  sort_unique(held);
  for (const BodyId id : held) {
    const Body& body = world.bodies[id];
    const double stress = world.material_of(body).density * wave_speed(world, body) * support.velocity.norm();
    changes.add(body, 0, stress);
    changes.add(body, stop, stress);
  }
}

}  // namespace

std::vector<QuickChange> quick_changes(const WorldState& world, const TimeSpan& span) {
  Changes changes(world, span);
  for (const PlacedLoad& placed : world.loads) add_changes(world, placed, changes);
  for (const PlacedSupport& placed : world.supports) add_changes(world, placed, changes);
  return changes.found();
}

bool is_pulsed(const WorldState& world, const Body& body, const TimeSpan& span) {
  std::vector<double> moments;
  for (const QuickChange& change : quick_changes(world, span))
    if (change.body == body.id) moments.push_back(change.time.from);
  sort_unique(moments);
  return moments.size() > 1;
}

}  // namespace griffith
