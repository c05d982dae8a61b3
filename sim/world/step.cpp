#include "sim/world/step.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

#include "sim/world/bodies/acting_bonds.h"
#include "sim/world/bodies/expected_impacts.h"
#include "sim/world/conditions/projectiles.h"
#include "sim/world/conditions/push.h"
#include "sim/world/contact/contact_phase.h"
#include "sim/world/contact/large_strains.h"
#include "sim/world/energy/energy_phase.h"
#include "sim/world/explicit/explicit_obstacles.h"
#include "sim/world/explicit/explicit_regime.h"
#include "sim/world/explicit/similarity.h"
#include "sim/world/fracture/fracture_phase.h"
#include "sim/world/fracture/separation_phase.h"
#include "sim/world/grab_force.h"
#include "sim/world/impacts/struck_bodies.h"
#include "sim/world/motion/elastic_phase.h"
#include "sim/world/motion/equilibrium.h"
#include "sim/world/motion/explicit_integration.h"
#include "sim/world/motion/motion_phase.h"
#include "sim/world/output/publish.h"
#include "sim/world/overload.h"
#include "sim/world/regime/part_at_bonds.h"
#include "sim/world/regime/rest_phase.h"
#include "sim/world/state/world_state.h"
#include "sim/world/strain_limit.h"
#include "sim/world/substeps.h"

namespace griffith {
namespace {

/// Calls work() and adds its milliseconds to a phase; for display only. Returns what the work returns.
template <class Work>
auto timed(double& milliseconds, const Work& work) {
  using Clock = std::chrono::steady_clock;
  struct Timer {
    double& milliseconds;
    Clock::time_point start = Clock::now();
    ~Timer() { milliseconds += std::chrono::duration<double, std::milli>(Clock::now() - start).count(); }
  } timer{milliseconds};
  return work();
}

/// Finds separation and fracture under the stresses after a substep of this length [s].
void fracture(WorldState& world, double substep) {
  StepTimings& ms = world.report.milliseconds;
  const bool averaged = world.model->scene.analysis == Analysis::dynamic;
  timed(ms.separation, [&] { evaluate_separation(world, averaged); });
  if (world.model->scene.simulation.fracture) timed(ms.fracture, [&] { open_cracks(world, substep); });
}

/// Computes contacts and motion of all objects except the bodies in explicit dynamics. Contacts that come about in the
/// substep are solved with the others where `leave` does not remove them.
void move(WorldState& world, double dt, const MeetingFilter& leave = {}) {
  StepTimings& ms = world.report.milliseconds;
  world.elements.own_states();
  update_supports(world, world.time, dt);
  timed(ms.contact, [&] { find_contacts(world, dt); });
  record_substep_start(world, world.scratch);
  timed(ms.elasticity, [&] {
    assemble_systems(world, dt);
    update_grab(world, dt);
  });
  ExternalForces forces = external_forces(world, dt);
  const std::vector<Vec3> external = std::move(forces.nodes);
  world.scratch.edge_loads = std::move(forces.edges);
  timed(ms.elasticity, [&] { predict_velocities(world, external, dt); });
  std::vector<ElasticMove> moves = timed(ms.contact, [&] { return resolve_contacts(world, external, dt, leave); });
  timed(ms.elasticity, [&] { move_bodies(world, external, std::move(moves), dt); });
  open_bonds(world);
}

void take_substep(WorldState& world, double dt) {
  move(world, dt);
  world.time += dt;
  fracture(world, dt);
}

/// Shows the world after a substep of explicit integration, which is a microstep of all bodies.
void show_substep(WorldState& world) {
  if (!world.watch || !world.watch->wants_next()) return;
  WorldState moment = world;
  moment.watch = nullptr;
  publish(moment);
  world.watch->take(world.watch->microsteps, std::move(moment));
}

/// Makes equal substeps; if cracks or cuts leave smaller elements, the rest of the step continues in shorter ones.
void step_explicitly(WorldState& world, double time_step) {
  constexpr double kRounding = 1e-9;
  world.report.substeps = 0;
  for (double left = time_step; left > 0; ++world.report.substeps) {
    const double count = std::max(1.0, std::ceil((1 - kRounding) * left / stable_substep(world)));
    const double dt = left / count;
    take_substep(world, dt);
    show_substep(world);
    left = count > 1 ? left - dt : 0;
  }
  rigidify_quiet_bodies(world);
  update_sleep(world, time_step);
}

/// Makes a substep up to the next impact, and another one: waves and the speed of cracks are not followed.
void step_implicitly(WorldState& world, double time_step) {
  const double impact = time_before(expected_impacts(world, time_step), time_step), tolerance = impact_tolerance(world);
  const bool is_cut = impact >= tolerance && time_step - impact >= tolerance;
  world.report.substeps = 0;
  for (const double dt : {is_cut ? impact : 0, is_cut ? time_step - impact : time_step}) {
    if (dt == 0) continue;
    take_substep(world, dt);
    ++world.report.substeps;
  }
  rigidify_quiet_bodies(world);
  update_sleep(world, time_step);
}

/// State before a substep that may be undone, and the number of microsteps that the observer had seen.
struct BeforeSubstep {
  explicit BeforeSubstep(const WorldState& now) : world(now), microsteps(now.watch ? now.watch->microsteps : 0) {}

  WorldState world;
  std::int64_t microsteps;
};

/// Restores the state before a substep, whose microsteps the observer forgets.
void restore(WorldState& world, const BeforeSubstep& before) {
  world = before.world;
  if (world.watch) world.watch->go_back(before.microsteps);
}

/// Moves everything on by `substep` [s]: by microsteps what is in explicit dynamics, all else by one implicit substep.
/// False where the microsteps would take more than `max_work`: the world is of no use then.
bool move_along(WorldState& world, double substep, double max_work, StepImpacts& impacts) {
  const std::vector<explicit_dynamics::Obstacle> obstacles = reachable_obstacles(world, substep);
  move(world, substep, [&](const WorldState& now, std::vector<ContactWorld::Meeting>& meetings) {
    impacts.take_harmful(now, substep, meetings);
  });
  if (!any_explicit(world)) return true;
  return timed(world.report.milliseconds.explicit_dynamics, [&] {
    const bool is_done = run_explicit(world, obstacles, substep, max_work);
    if (is_done) place_proxies(world);
    return is_done;
  });
}

/// Moves everything on by `substep` [s]. Where that takes more than half of the work that is left for microsteps in
/// this step, restores the state before except for the measured cost: impacts and cracks make it hard to predict.
bool move_within_ceiling(WorldState& world, double substep, StepImpacts& impacts) {
  constexpr double kUncertainty = 16;  // contacts, checks and cracks may take so many times what was expected
  const double max_work = 0.5 * work_left(world);
  if (kUncertainty * expected_work(world, substep) < max_work)
    return move_along(world, substep, std::numeric_limits<double>::infinity(), impacts);
  const BeforeSubstep before(world);
  if (move_along(world, substep, max_work, impacts)) return true;
  const double work = world.scratch.microstep_work, overhead = world.explicit_overhead;
  restore(world, before);
  world.scratch.microstep_work = work;
  world.explicit_overhead = overhead;
  return false;
}

/// Most substeps of a step that are undone: for strains, for loads.
constexpr int kMaxUndone = 12, kMaxLate = 16;

/// Moves everything on by `substep` [s]. Where the nonlinear step of a soft body does not converge, or one turns so far
/// that it comes to lie below the ground, restores the state before and halves the limit, but not more than some times
/// in a step.
bool move_within_strains(WorldState& world, double substep, SubstepLimit& limit, StepImpacts& impacts) {
  constexpr double kDeep = 1e-3;  // in sizes of elements
  if (substep < 2 * limit.shortest || limit.undone == kMaxUndone || !may_strain_far(world))
    return move_within_ceiling(world, substep, impacts);
  const BeforeSubstep before(world);
  if (!move_within_ceiling(world, substep, impacts)) return false;
  const bool has_converged = world.report.unconverged_motions == before.world.report.unconverged_motions;
  if (has_converged && depth_of_soft_bodies(world) <= std::max(kDeep, depth_of_soft_bodies(before.world))) return true;
  restore(world, before);
  limit.longest = substep / 2;
  ++limit.undone;
  return false;
}

/// Returns the state before a substep [s] that has to be undone if it overloads bodies; none if it may not.
std::optional<BeforeSubstep> keep_if_overloading(const WorldState& world, double substep, const SubstepLimit& limit) {
  if (substep < 2 * limit.shortest_if_held || limit.late == kMaxLate || !may_overload(world)) return std::nullopt;
  return BeforeSubstep(world);
}

/// Restores the state before a substep [s] in which bodies became overloaded long before its end, or by whose damping
/// alone they may have held, and limits the next one up to there or to half of it. False if there were none.
bool undo_if_overloaded(WorldState& world, const BeforeSubstep& before, double substep, SubstepLimit& limit) {
  constexpr double kHalf = 0.5;
  const double fraction =
      substep < 2 * limit.shortest ? 1 : fraction_until_overload(before.world, world, limit.last / substep);
  const bool is_held = fraction == 1 && may_be_held_by_damping(world, substep, limit.shortest);
  if (fraction == 1 && !is_held) return false;
  restore(world, before);
  limit.longest = is_held ? kHalf * substep : std::max(fraction * substep, limit.shortest);
  ++limit.late;
  return true;
}

/// Returns the longest substep in which no more than a few bodies turn far [s]. Contacts among fragments that turn
/// several times in a substep would be found one after the other, and everything solved again each time. `shortest`:
/// lower limit of it [s].
double turning_limit(const WorldState& world, double shortest) {
  constexpr double kFar = 2;       // [rad]
  constexpr std::size_t kFew = 8;  // chips that spin fast do not shorten the substeps of all others
  std::vector<double> spins;
  for (const Body& body : world.bodies)
    if (!body.asleep && !body.supported()) spins.push_back(body.motion.angular_velocity.norm());
  if (spins.size() <= kFew) return std::numeric_limits<double>::infinity();
  std::ranges::nth_element(spins, spins.begin() + kFew, std::ranges::greater());
  return std::max(kFar / spins[kFew], shortest);
}

/// True if another body or a projectile is about to strike a body within `left` [s] that has come out of microsteps
/// since `start` [s], in a step with cracks, and now deforms without them.
bool is_struck_again(const WorldState& world, double start, double left) {
  const auto has_broken = [&](BodyId id) {
    return id.valid() && world.bodies[id].is_deformable() && world.bodies[id].explicit_ended > start;
  };
  const auto matters = [&](BodyId a, BodyId b) {
    return (has_broken(a) || has_broken(b)) && !have_just_parted(world, a, b);
  };
  if (world.report.cracks == 0 || any_explicit(world)) return false;
  const auto lacks_ground = [&](const ContactWorld::Encounter& met) {
    return !world.contact_world.is_ground(met.a) && !world.contact_world.is_ground(met.b);
  };
  return std::ranges::any_of(expected_impacts(world, left, matters), lacks_ground);
}

/// Returns the length of the next substep of a step with `left` [s] to go [s]. Where what has just broken goes on
/// without microsteps though something passes through it, substeps start short and grow: contacts are those of the
/// start of a substep, in which faces beside a hole would stop it.
double choose_substep(WorldState& world, double left, SubstepLimit& limit, StepImpacts& impacts) {
  const double last_start = world.time - limit.last;
  const bool was_followed = world.report.unfinished_explicit == 0;
  const double next = next_substep(world, left, impacts);
  if ((was_followed && world.report.unfinished_explicit > 0) || is_struck_again(world, last_start, left))
    limit.longest = limit.shortest;
  return std::min({limit.longest, turning_limit(world, limit.shortest), next});
}

/// Makes substeps: up to the next impact, and while waves run in bodies that were hit or crack. Bodies in explicit
/// dynamics take microsteps through a substep, all else one implicit substep, after which what is too soft for
/// microsteps cracks. A substep in which cracks would begin late is undone, and ends where they begin.
void step_in_substeps(WorldState& world, double time_step) {
  constexpr double kRounding = 1e-9, kGrowth = 1.25;
  StepTimings& ms = world.report.milliseconds;
  world.report.substeps = 0;
  world.scratch.microstep_work = 0;
  SubstepLimit limit = strain_limit(world, time_step);
  StepImpacts impacts;
  for (double left = time_step; left > kRounding * time_step; ++world.report.substeps) {
    const double start = world.time, substep = choose_substep(world, left, limit, impacts);
    const std::optional<BeforeSubstep> before = keep_if_overloading(world, substep, limit);
    timed(ms.explicit_dynamics, [&] { impacts.follow_alone(world, substep); });
    if (!move_within_strains(world, substep, limit, impacts)) continue;
    limit.longest *= kGrowth;
    impacts.catch_up(world);
    timed(ms.explicit_dynamics, [&] { impacts.follow_late(world, start, substep); });
    world.time = start + substep;
    end_explicit_if_quiet(world);
    part_at_bonds(world);
    timed(ms.separation, [&] { evaluate_separation(world, true); });
    if (before && undo_if_overloaded(world, *before, substep, limit)) continue;
    left -= limit.last = substep;
    timed(ms.separation, [&] { begin_explicit_if_overloaded(world); });
    if (world.model->scene.simulation.fracture) open_cracks(world, substep);
  }
  world.last_microstep_work = world.scratch.microstep_work;
  world.report.microstep_work = 1e-3 * (world.scratch.microstep_work + impacts.work());
  world.report.microsteps += impacts.microsteps();
  rigidify_quiet_bodies(world);
  update_sleep(world, time_step);
}

/// True if neither loads nor supports change the balance in the step from `time` [s].
bool stays_in_equilibrium(const WorldState& world, double time, double time_step) {
  return world.in_equilibrium &&
         std::ranges::none_of(world.loads,
                              [&](const PlacedLoad& placed) {
                                return load_factor(placed.load, time) != load_factor(placed.load, time + time_step);
                              }) &&
         std::ranges::all_of(world.nodes.constraints,
                             [](const NodeConstraint& held) { return held.velocity.isZero(0); });
}

/// Finds one equilibrium after the other, without inertia, as loads and supports change. Each crack changes the
/// balance, so it is found again until nothing more cracks or the budget ends.
void step_statically(WorldState& world, double time_step) {
  const int budget = world.model->scene.simulation.impact_substeps;
  double displacement_time = time_step;
  world.time += time_step;
  world.in_equilibrium = false;
  int cracks_before = -1;
  for (world.report.substeps = 0; world.report.cracks > cracks_before; ++world.report.substeps) {
    timed(world.report.milliseconds.elasticity, [&] {
      find_equilibrium(world, world.time, displacement_time, [](const Body&) { return true; });
      update_elements(world);
    });
    displacement_time = 0;
    if (world.report.substeps == budget) {
      ++world.report.unfinished_equilibria;
      return evaluate_separation(world, false);
    }
    cracks_before = world.report.cracks;
    fracture(world, std::numeric_limits<double>::infinity());
  }
  world.in_equilibrium = world.report.unconverged_solves == 0 && world.report.cracks_postponed == 0;
}

/// True if a step would move nothing: all are asleep, according to the contact world in the last step.
bool all_lie_asleep(const WorldState& world) {
  return world.loads.empty() && world.postponed.empty() && world.contact_world.contacts().empty() &&
         std::ranges::all_of(world.bodies, &Body::asleep) &&
         std::ranges::all_of(world.projectiles, [&](const Projectile& projectile) {
           return world.contact_world.asleep(projectile.object);
         });
}

void move_by_integrator(WorldState& world, double time_step) {
  if (world.integrates_explicitly()) return step_explicitly(world, time_step);
  const bool is_hybrid = world.model->scene.simulation.integrator == Integrator::hybrid;
  is_hybrid ? step_in_substeps(world, time_step) : step_implicitly(world, time_step);
}

/// Reports that nothing has changed since the step with the report `last`.
void stand_still(WorldState& world, const StepReport& last) {
  world.report.peak_utilization = last.peak_utilization;
  world.report.sleeping_bodies = static_cast<int>(std::ranges::count_if(world.bodies, &Body::asleep));
}

/// Makes the step that follows the step with the report `last`. Returns false if all are asleep, so that nothing
/// changes but the time.
bool make_step(WorldState& world, const StepReport& last) {
  const double time_step = world.model->scene.simulation.time_step;
  launch_projectiles(world);
  update_supports(world, world.time, time_step);
  make_loaded_bodies_elastic(world, {world.time - time_step, world.time}, {world.time, world.time + time_step});
  make_first_struck_elastic(world, time_step);
  const bool is_static = world.model->scene.analysis == Analysis::static_, asleep = all_lie_asleep(world);
  if (asleep || (is_static && stays_in_equilibrium(world, world.time, time_step))) {
    stand_still(world, last);
  } else {
    is_static ? step_statically(world, time_step) : move_by_integrator(world, time_step);
  }
  ++world.step;
  world.time = static_cast<double>(world.step) * time_step;
  end_pushes(world);
  return !asleep;
}

/// Clears what the report and the views say of the last step. Returns its report.
StepReport begin_report(WorldState& world) {
  world.output.contacts.clear();
  world.energy_before = world.energy;
  for (Body& body : world.bodies)
    if (!body.explicit_state) body.scaled.reset();
  return std::exchange(world.report, {});
}

}  // namespace

void advance(WorldState& world) {
  const StepReport last = begin_report(world);
  const bool has_changed = timed(world.report.milliseconds.step, [&] { return make_step(world, last); });
  if (has_changed) publish(world);
}

}  // namespace griffith
