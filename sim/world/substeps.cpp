#include "sim/world/substeps.h"

#include <algorithm>
#include <utility>

#include "sim/world/bodies/bodies.h"
#include "sim/world/bodies/expected_impacts.h"
#include "sim/world/conditions/quick_changes.h"
#include "sim/world/explicit/body_frequency.h"
#include "sim/world/explicit/explicit_regime.h"
#include "sim/world/explicit/similarity.h"
#include "sim/world/impacts/struck_bodies.h"
#include "sim/world/regime/part_at_bonds.h"
#include "sim/world/regime/regime_change.h"
#include "sim/world/regime/torn_bonds.h"

namespace griffith {
namespace {

/// True if a body pressed in the last substep on one that is too soft for microsteps, which know that one as a rigid
/// object: the force would be missing.
bool presses_on_soft_body(const WorldState& world, const Body& body) {
  return std::ranges::any_of(body.known_contact_loads, [&](const ContactLoad& load) {
    const BodyId id = world.body_of(load.other);
    return id.valid() && deforms_visibly(world, world.bodies[id]) && !suits_microsteps(world, world.bodies[id], 0);
  });
}

/// Returns quick changes of loads and supports within `duration` [s] on bodies suited to microsteps.
std::vector<QuickChange> changes_for_microsteps(const WorldState& world, double duration) {
  constexpr double kRounding = 1e-9;
  const double now = world.time, past = kRounding * world.model->scene.simulation.time_step;
  std::vector<QuickChange> changes = quick_changes(world, {now - past, now + duration});
  std::erase_if(changes, [&](const QuickChange& change) {
    const Body& body = world.bodies[change.body];
    return !body.explicit_state && (!suits_microsteps(world, body, 0) || presses_on_soft_body(world, body));
  });
  return changes;
}

double time_before_change(const WorldState& world, double maximum) {
  double time = maximum;
  for (const QuickChange& change : changes_for_microsteps(world, maximum))
    time = std::min(time, std::max(0.0, change.time.from - world.time));
  return time;
}

/// Begins explicit dynamics of bodies in which loads and supports cause waves within `duration` [s].
void begin_explicit_if_driven(WorldState& world, double duration) {
  for (const QuickChange& change : changes_for_microsteps(world, duration)) {
    Body& body = world.bodies[change.body];
    begin_explicit(world, body, 0);
    if (body.explicit_state)
      body.explicit_state->last_event =
          std::max(body.explicit_state->last_event, std::min(change.time.to, world.time + duration));
  }
}

/// Returns the time until the first of these, `maximum` if there are none [s].
double time_before(const std::vector<Impact>& impacts, double maximum) {
  double time = maximum;
  for (const Impact& impact : impacts) time = std::min(time, impact.met.time);
  return time;
}

/// Begins explicit dynamics of bodies that deform in impacts within `duration` [s].
void begin_explicit_if_struck(WorldState& world, const std::vector<Impact>& impacts, double duration) {
  for (const Impact& impact : impacts) {
    if (impact.met.time > duration) continue;
    if (have_just_parted(world, impact.bodies[0], impact.bodies[1])) continue;  // one of the two has entered by now
    for (int i = 0; i < 2; ++i)
      if (impact.deforms[i]) begin_explicit(world, world.bodies[impact.bodies[i]], impact.met.approach);
  }
}

/// Begins explicit dynamics of bodies with bonds that contacts have loaded.
void begin_explicit_if_bonds_loaded(WorldState& world) {
  for (Body& body : world.bodies)
    if (std::exchange(body.bonds_loaded, false) && body.rigid) begin_explicit(world, body, 0);
}

/// Leaves the rest of the step to the implicit step.
void cancel_explicit(WorldState& world) {
  std::vector<BodyId> ended;
  for (Body& body : world.bodies) {
    if (!body.explicit_state) continue;
    end_explicit(world, body);
    ended.push_back(body.id);
    ++world.report.unfinished_explicit;
  }
  for (const BodyId id : part_at_torn_bonds(world, ended)) {
    Body& body = world.bodies[id];
    if (body.is_deformable() && !body.supported()) stop_vibration(world, body);
  }
  part_at_bonds(world);
}

}  // namespace

double next_substep(WorldState& world, double left, StepImpacts& impacts) {
  begin_explicit_if_bonds_loaded(world);
  std::vector<Impact> shared;
  if (!any_explicit(world)) {
    world.explicit_overhead = 1;
    shared = impacts.find(world, left);
    const double undisturbed = std::min(time_before(shared, left), time_before_change(world, left));
    if (undisturbed > impact_tolerance(world) || undisturbed == left) return undisturbed;
  }
  if (is_spent(world)) {
    cancel_explicit(world);
    return left;
  }
  const double substep = planned_substep(world, left);
  if (any_explicit(world)) shared = impacts.find(world, substep);
  begin_explicit_if_struck(world, shared, substep);
  begin_explicit_if_driven(world, substep);
  if (!any_explicit(world)) return left;
  for (Body& body : world.bodies)
    if (body.explicit_state) limit_frequency(world, body);
  choose_similarity(world, left);
  return planned_substep(world, left);
}

}  // namespace griffith
