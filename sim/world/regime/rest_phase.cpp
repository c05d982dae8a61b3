#include "sim/world/regime/rest_phase.h"

#include <algorithm>
#include <cmath>

#include "sim/world/bodies/bodies.h"
#include "sim/world/bodies/collision_shape.h"
#include "sim/world/contact/contact_phase.h"
#include "sim/world/energy/energy_phase.h"
#include "sim/world/fracture/separation_phase.h"
#include "sim/world/impacts/struck_bodies.h"
#include "sim/world/motion/elastic_phase.h"
#include "sim/world/motion/motion_phase.h"
#include "sim/world/regime/regime_change.h"

namespace griffith {
namespace {

/// True if stress and waves in a free body are far too small for damage, and invisible. A wave of stress σ moves nodes
/// by σ/(ρc), in compression as in tension, before it arrives where it could separate the body.
bool is_quiescent(const WorldState& world, const Body& body) {
  constexpr double kQuietUtilization = 0.05, kQuietSpeed = 0.1;
  const auto is_quiet = [&](NodeId node) { return world.nodes.separations[node].utilization < kQuietUtilization; };
  return !sags_visibly(world, body) && !is_visibly_strained(world, body) && std::ranges::all_of(body.nodes, is_quiet) &&
         all_slower(world, body, motion_of(world, body),
                    std::min(kQuietSpeed * damage_speed(world, body), visible_speed(world, body)));
}

/// True if contacts hold a thin body in a bent shape, which no hull of a rigid body has: it falls asleep as it is.
bool is_held_bent(const WorldState& world, const Body& body) {
  return !body.known_contact_loads.empty() && is_bent_by(world, body, shape_tolerance(body));
}

/// True if a body that has turned rigid in free flight may deform visibly where something first meets it. Impacts of
/// others are judged one by one (step_impacts.h).
bool yields_at_first_touch(const WorldState& world, const Body& body) {
  if (body.tets.size() == 1) return false;
  return world.model->scene.simulation.integrator != Integrator::hybrid ||
         (!suits_microsteps(world, body, 0) && !suits_rebound(world, body, 0));
}

/// True if a free body had no contacts in the last substep and has no stress or waves: a rigid one would move alike.
bool flies_unstressed(const WorldState& world, const Body& body) {
  constexpr double kUnstressed = 1e-3, kUnseen = 0.1;  // of the breaking and of the visible strain
  if (!body.known_contact_loads.empty()) return false;
  const double stress =
      std::min(kUnstressed * min_breaking_stress(world, body, true), kUnseen * visible_stress(world, body));
  const double strain = stress / world.material_of(body).young_modulus;
  return mechanical_energy(world, body) - kinetic_energy(motion_of(world, body)) <
         energy_of_strain(world, body, strain);
}

/// True if a body has hardly left its place [m].
bool stays(const Body& body) {
  constexpr double kStillFraction = 0.005;  // of its extent
  const double turned = 2 * (body.rest.place.rotation.conjugate() * body.orientation).vec().norm() * body.extent / 2;
  return (body.motion.center - body.rest.place.translation).norm() + turned <= kStillFraction * body.extent;
}

/// True if no wave in a body could cause damage, and no motion is visible. Bodies held only by supports may swing, and
/// are nearly still twice a period.
bool is_still(const WorldState& world, const Body& body) {
  constexpr double kSafeSpeed = 0.25, kVisible = 0.02, kSwinging = 1e-6;  // the last two of its extent [1/s]
  const bool touched = !body.known_contact_loads.empty();
  const RigidMotion whole = touched ? motion_of(world, body) : RigidMotion();
  return all_slower(world, body, whole,
                    std::min(kSafeSpeed * damage_speed(world, body), (touched ? kVisible : kSwinging) * body.extent));
}

/// True if a deformable body, after a step, is as it was when its rest began, and far from breaking. Friction lets
/// loads of wedged bodies vary permanently.
bool goes_on_resting(const WorldState& world, const Body& body, double peak) {
  constexpr double kSameUtilization = 0.2, kFarFromBreaking = 0.75;
  return peak < kFarFromBreaking && std::abs(peak - body.rest.peak_utilization) < kSameUtilization && stays(body) &&
         is_still(world, body);
}

void update_rest(const WorldState& world, Body& body, double time_step) {
  const double peak = peak_utilization(world, body);
  if (goes_on_resting(world, body, peak)) return void(body.rest.time += time_step);
  body.rest = {0, {body.motion.center, body.orientation}, peak};
}

/// Returns the bodies that never settle: those under loads or moving supports, now or later, and all under explicit
/// integration.
std::vector<bool> driven_bodies(const WorldState& world) {
  std::vector<bool> driven(world.bodies.size(), world.integrates_explicitly());
  const auto mark = [&](TetId tet) { driven[world.elements.bodies[tet]] = true; };
  for (const PlacedLoad& placed : world.loads) {
    for (const TetCorner& corner : placed.corners) mark(corner.tet);
    for (const SurfaceFace& face : placed.faces) mark(face.tet);
    for (const TetId tet : placed.tets) mark(tet);
    if (placed.point) mark(placed.point->tet);
  }
  for (const PlacedSupport& placed : world.supports)
    if (!placed.support.velocity.isZero(0))
      for (const TetCorner& corner : placed.corners) mark(corner.tet);
  return driven;
}

/// Reports to the contact world which of the deformable bodies have settled.
void report_settled_bodies(WorldState& world, double time_step) {
  const std::vector<bool> driven = driven_bodies(world);
  for (Body& body : world.bodies) {
    if (body.asleep) continue;
    std::optional<bool> settled;
    if (!body.rigid || driven[body.id]) settled = false;
    if (body.is_deformable() && !driven[body.id]) {
      update_rest(world, body, time_step);
      settled = body.rest.time >= ContactWorld::kTimeToSleep;
    }
    world.contact_world.set_settled(body.proxy, settled);
  }
}

void turn_rigid(WorldState& world, Body& body) {
  const double before = energy_of(world, body);
  make_rigid(world, body);
  world.energy.regime_change += before - energy_of(world, body);
}

/// Takes what is left of a body's motion.
void fall_asleep(WorldState& world, Body& body) {
  const double before = energy_of(world, body);
  body.motion.velocity = body.motion.angular_velocity = Vec3::Zero();
  for (const NodeId node : body.nodes) world.nodes.velocities[node].setZero();
  for (const EdgeId edge : body.edges) world.edges.velocities[edge].setZero();
  world.energy.regime_change += before - energy_of(world, body);
}

}  // namespace

void rigidify_if_quiescent(WorldState& world, Body& body) {
  if (!body.is_deformable() || body.supported() || !is_quiescent(world, body) || is_held_bent(world, body)) return;
  set_ballistic(world, body, false);
  turn_rigid(world, body);
}

void rigidify_quiet_bodies(WorldState& world) {
  constexpr int kLeastSteps = 20;
  constexpr double kLeastTime = 0.1;  // [s]: a slow swing is quiet for a moment wherever it turns back
  const double time_step = world.model->scene.simulation.time_step;
  const int quiet_steps = std::max(kLeastSteps, static_cast<int>(std::ceil(kLeastTime / time_step)));
  const std::vector<bool> strained = strained_bodies(world, {world.time - time_step, world.time});
  for (Body& body : world.bodies) {
    if (body.ballistic && ++body.quiet_steps == quiet_steps) set_ballistic(world, body, false);
    if (!body.is_deformable() || body.supported()) continue;
    body.quiet_steps = !strained[body.id] && is_quiescent(world, body) ? body.quiet_steps + 1 : 0;
    const bool flies = body.quiet_steps > 0 && flies_unstressed(world, body);
    if (body.tets.size() > 1 && !flies && (body.quiet_steps < quiet_steps || is_held_bent(world, body))) continue;
    set_ballistic(world, body, body.quiet_steps < quiet_steps && yields_at_first_touch(world, body));
    turn_rigid(world, body);
  }
}

void update_sleep(WorldState& world, double time_step) {
  const double moving = kinetic_energy_of_projectiles(world);
  report_settled_bodies(world, time_step);
  world.contact_world.fall_asleep(time_step);
  world.energy.regime_change += moving - kinetic_energy_of_projectiles(world);
  for (Body& body : world.bodies) {
    const bool slept = body.asleep;
    body.asleep = world.contact_world.asleep(body.proxy);
    world.report.sleeping_bodies += body.asleep;
    if (body.asleep && !slept) fall_asleep(world, body);
  }
}

void join_substep(WorldState& world, Body& body, bool slept, double dt) {
  BodyStep& step = world.scratch.bodies[body.id];
  step.start.rigid = !slept;
  step.contact_work = 0;
  step.energy = mechanical_energy(world, body);
  assemble_system(world, body, dt);
  if (slept) predict_velocities(world, body, external_forces(world, dt).nodes, dt);
}

void wake_disturbed_bodies(WorldState& world, double dt) {
  for (Body& body : world.bodies) {
    const bool slept = body.asleep;
    body.asleep = world.contact_world.asleep(body.proxy);
    if (slept && !body.asleep && body.is_deformable()) join_substep(world, body, true, dt);
  }
}

}  // namespace griffith
