#include "sim/world/impacts/step_impacts.h"

#include <algorithm>
#include <set>
#include <utility>

#include "sim/core/parallel.h"
#include "sim/world/bodies/impact_speeds.h"
#include "sim/world/conditions/loads.h"
#include "sim/world/contact/contact_phase.h"
#include "sim/world/explicit/similarity.h"
#include "sim/world/regime/rest_phase.h"

namespace griffith {
namespace {

/// Fraction of a step's budget for the trial of an impact, or for following it alone.
constexpr double kShareOfBudget = 1.0 / 8;

std::pair<ProxyId, ProxyId> key_of(const Impact& impact) { return std::minmax(impact.met.a, impact.met.b); }

double work_of_one(const WorldState& world) { return 1e3 * kShareOfBudget * world.model->scene.simulation.step_budget; }

/// True if two pieces belong to one scene body: they touch in shared microsteps if only cracks separated them.
bool are_of_one_body(const WorldState& world, const Impact& impact) {
  const auto [a, b] = impact.bodies;
  return a.valid() && b.valid() && world.bodies[a].scene_body == world.bodies[b].scene_body;
}

/// True if the waves of an impact end within a small part of a step.
bool is_short(const WorldState& world, const Impact& impact) {
  for (int i = 0; i < 2; ++i)
    if (impact.deforms[i] && responds_slowly(world, world.bodies[impact.bodies[i]])) return false;
  return true;
}

/// True if a body moves as its supports let it.
bool moves_on_supports(const WorldState& world, const Body& body) {
  return body.supported() && !world.contact_world.state(body.proxy).is_still();
}

/// True if an impact is judged by itself.
bool has_trial(const WorldState& world, const Impact& impact) {
  return !is_shot(world, impact) && is_short(world, impact) && expected_work(world, impact) <= work_of_one(world);
}

}  // namespace

bool StepImpacts::is_safe(const Impact& impact) const {
  constexpr double kSame = 1.1;  // speed, of one that was tried
  const auto known = safe_speeds_.find(key_of(impact));
  return known != safe_speeds_.end() && impact.met.approach <= kSame * known->second;
}

bool StepImpacts::goes_alone(const WorldState& world, const Impact& impact) const {
  for (int i = 0; i < 2; ++i) {
    const BodyId id = impact.bodies[i];
    if (!id.valid()) continue;
    const Body& body = world.bodies[id];
    if (body.explicit_state || (impact.deforms[i] && body.supported()) || moves_on_supports(world, body)) return false;
  }
  return is_short(world, impact);
}

/// True for an impact that is known to be safe, or left to the contacts of pieces that only cracks separated.
bool StepImpacts::needs_no_trial(const WorldState& world, const Impact& impact) const {
  return is_safe(impact) || (are_of_one_body(world, impact) && !goes_alone(world, impact));
}

Flights StepImpacts::flights_of(const Impact& impact) const {
  Flights flights;
  for (int i = 0; i < 2; ++i) {
    const auto ahead = ahead_.find(impact.bodies[i]);
    flights[i] = impact.met.strike - (ahead == ahead_.end() ? 0 : ahead->second);
  }
  return flights;
}

bool StepImpacts::is_ahead(const Impact& impact) const {
  return std::ranges::any_of(impact.bodies, [&](BodyId id) { return ahead_.contains(id); });
}

/// Returns the outcomes of trials; impacts without one count as harmful.
std::vector<TrialOutcome> StepImpacts::try_all(const WorldState& world, const std::vector<Impact>& impacts,
                                               const std::function<std::array<RigidState, 2>(const Impact&)>& states_of,
                                               double until) {
  std::vector<TrialOutcome> outcomes(impacts.size());
  parallel_for(static_cast<int>(impacts.size()), 1, [&](int begin, int end) {
    for (int i = begin; i < end; ++i) {
      outcomes[i].harmful = true;
      if (has_trial(world, impacts[i]))
        outcomes[i] = try_impact(world, impacts[i], states_of(impacts[i]), until - impacts[i].met.strike);
    }
  });
  for (std::size_t i = 0; i < impacts.size(); ++i) {
    work_ += outcomes[i].work;
    if (outcomes[i].touched && !outcomes[i].harmful) safe_speeds_[key_of(impacts[i])] = impacts[i].met.approach;
  }
  return outcomes;
}

std::vector<Impact> StepImpacts::find(const WorldState& world, double duration) {
  std::vector<Impact> impacts = harmful_impacts(world, duration), shared;
  std::erase_if(impacts, [&](const Impact& impact) { return needs_no_trial(world, impact); });
  const std::vector<TrialOutcome> outcomes = try_all(
      world, impacts, [&](const Impact& impact) { return flown(world, impact, flights_of(impact)); }, 0);
  alone_.clear(), safe_bodies_.clear();
  for (std::size_t i = 0; i < impacts.size(); ++i) {
    if (!outcomes[i].harmful) {
      safe_bodies_.insert(safe_bodies_.end(), impacts[i].bodies.begin(), impacts[i].bodies.end());
    } else if (outcomes[i].touched && goes_alone(world, impacts[i])) {
      alone_.push_back({impacts[i], outcomes[i].contact});
    } else if (!are_of_one_body(world, impacts[i])) {
      shared.push_back(impacts[i]);
    }
  }
  std::ranges::stable_sort(alone_, {}, [](const Alone& alone) { return alone.impact.met.strike; });
  return shared;
}

/// Makes free bodies rigid for which only safe impacts and no straining loads are ahead: the mean force of an impact in
/// a step does not predict its stress.
void StepImpacts::turn_rigid(WorldState& world) {
  const double time_step = world.model->scene.simulation.time_step;
  const std::vector<bool> strained = strained_bodies(world, {world.time, world.time + time_step});
  for (const BodyId id : std::exchange(safe_bodies_, {}))
    if (id.valid() && !strained[id]) rigidify_if_quiescent(world, world.bodies[id]);
}

void StepImpacts::follow(WorldState& world, Alone alone, double wait) {
  if (wait > 0 || is_ahead(alone.impact)) {  // it has met something else since, or moved otherwise
    const std::array<RigidState, 2> states = flown(world, alone.impact, flights_of(alone.impact));
    const TrialOutcome outcome = try_impact(world, alone.impact, states, wait);
    work_ += outcome.work;
    if (!outcome.harmful) return;
    alone.contact = outcome.contact;
  }
  const Followed followed = follow_impact(world, alone.impact, flights_of(alone.impact), alone.contact);
  for (const BodyId id : followed.bodies) ahead_[id] = alone.impact.met.strike + alone.contact + followed.time;
  work_ += followed.work;
  microsteps_ += followed.microsteps;
}

void StepImpacts::follow_alone(WorldState& world, double duration) {
  turn_rigid(world);
  late_.clear();
  for (const Alone& alone : std::exchange(alone_, {})) {
    if (alone.impact.met.strike > duration) break;
    follow(world, alone);
  }
  if (!ahead_.empty()) place_proxies(world);
}

void StepImpacts::take_harmful(const WorldState& world, double duration, std::vector<ContactWorld::Meeting>& meetings) {
  std::vector<ContactWorld::Encounter> encounters;
  std::map<std::pair<ProxyId, ProxyId>, const ContactWorld::Meeting*> meeting_of;
  for (const ContactWorld::Meeting& meeting : meetings) {
    if (!meeting.impact) continue;
    encounters.push_back(*meeting.impact);
    meeting_of[std::minmax(meeting.objects[0], meeting.objects[1])] = &meeting;
  }
  std::vector<Impact> impacts = harmful_among(world, encounters);
  std::erase_if(impacts, [&](const Impact& impact) {
    return have_just_parted(world, impact.bodies[0], impact.bodies[1]) || needs_no_trial(world, impact);
  });
  const std::vector<TrialOutcome> outcomes = try_all(
      world, impacts,
      [&](const Impact& impact) {
        std::array<RigidState, 2> states = meeting_of.at(key_of(impact))->starts;
        for (int i = 0; i < 2; ++i) states[i] = flown(world, impact.objects()[i], states[i], impact.met.strike);
        return states;
      },
      duration);
  late_.clear();
  std::set<std::pair<ProxyId, ProxyId>> taken;
  for (std::size_t i = 0; i < impacts.size(); ++i) {
    if (!outcomes[i].harmful) continue;
    const bool is_followed = outcomes[i].touched && goes_alone(world, impacts[i]);
    if (is_followed) late_.push_back({impacts[i], outcomes[i].contact});
    if (is_followed || !meeting_of.at(key_of(impacts[i]))->is_deep) taken.insert(key_of(impacts[i]));
  }
  std::erase_if(meetings, [&](const ContactWorld::Meeting& meeting) {
    return taken.contains(std::minmax(meeting.objects[0], meeting.objects[1]));
  });
  std::ranges::stable_sort(late_, {}, [](const Alone& alone) { return alone.impact.met.strike; });
}

void StepImpacts::follow_late(WorldState& world, double start, double duration) {
  if (late_.empty()) return;
  world.time = start + duration;
  // What has met something else in the substep has fallen by up to g dt² less than what flies.
  const double fall = duration * duration * world.model->scene.gravity.norm();
  for (Alone& alone : std::exchange(late_, {})) {
    alone.impact.met.time -= duration;
    alone.impact.met.strike -= duration;
    follow(world, alone, fall / alone.impact.met.approach);
  }
  place_proxies(world);
  catch_up(world);
}

void StepImpacts::catch_up(WorldState& world) {
  if (ahead_.empty()) return;
  for (const auto& [id, time] : ahead_) fly(world, world.bodies[id], -time);
  ahead_.clear();
  place_proxies(world);
}

}  // namespace griffith
