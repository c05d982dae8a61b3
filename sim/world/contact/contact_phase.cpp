#include "sim/world/contact/contact_phase.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "sim/core/parallel.h"
#include "sim/core/rotation.h"
#include "sim/solver/rigid_motion.h"
#include "sim/world/bodies/bodies.h"
#include "sim/world/bodies/bonded_pieces.h"
#include "sim/world/bodies/expected_impacts.h"
#include "sim/world/contact/elastic_contacts.h"
#include "sim/world/contact/face_contacts.h"
#include "sim/world/contact/large_strains.h"
#include "sim/world/contact/quasi_static.h"
#include "sim/world/contact/respond.h"
#include "sim/world/contact/touched_body.h"
#include "sim/world/energy/energy_phase.h"
#include "sim/world/impacts/struck_bodies.h"
#include "sim/world/motion/elastic_phase.h"
#include "sim/world/motion/motion_phase.h"
#include "sim/world/motion/turning.h"
#include "sim/world/output/publish.h"
#include "sim/world/regime/regime_change.h"
#include "sim/world/regime/rest_phase.h"
#include "sim/world/state/world_state.h"

namespace griffith {
namespace {

/// Fraction of the resistance up to which a rigid body stays rigid.
constexpr double kWakingFraction = 0.25;

/// True if the bending by a force [N] that stays could bring a thin rigid piece near its strength, or be seen.
bool could_bend(const WorldState& world, const Body& body, double force) {
  constexpr double kLarge = 0.3;  // of the extent of the original: what shards carry is not worth its cost
  if (!is_thin(body) || body.extent < kLarge * world.model->extents[body.scene_body]) return false;
  const double damaging = kWakingFraction * min_breaking_stress(world, body, false);
  return bending_stress(world, body, force) > std::min(damaging, visible_bending_stress(world, body));
}

/// True if a force [N] could bring a rigid piece near its strength somewhere, or deform it visibly. Thin ones bend
/// under forces that stay; impacts are judged by their speed.
bool could_deform(const WorldState& world, const Body& body, double force, bool stays) {
  if (body.tets.size() == 1) return false;
  const double stress = force / (body.element_size * body.element_size),
               damaging = kWakingFraction * min_breaking_stress(world, body, true);
  return stress > std::min(damaging, visible_stress(world, body)) || (stays && could_bend(world, body, force));
}

/// True if two objects came together no faster than gravity and the substep `dt` [s] make those that rest.
bool is_at_rest(const WorldState& world, const Contact& contact, double dt) {
  constexpr double kSubsteps = 2;
  return contact.approach <= kSubsteps * dt * world.model->scene.gravity.norm();
}

/// True if the damage by a contact was predicted before the step: impacts have their own phase, and their mean force in
/// a long step does not predict it. Bodies too soft for microsteps are left to the implicit step.
bool is_left_to_microsteps(const WorldState& world, const Body& body, const Contact& contact) {
  const ProxyId other = contact.a == body.proxy ? contact.b : contact.a;
  return world.model->scene.simulation.integrator == Integrator::hybrid && contact.approach > min_impact_speed(world) &&
         (!deforms_visibly(world, body) || suits_microsteps(world, body, 0) ||
          suits_rebound_from(world, body, other, contact.approach));
}

/// Returns the force of another object on a body in a substep of `dt` [N].
Vec3 load_of(const WorldState& world, const Body& body, ProxyId other, double dt) {
  Vec3 force = Vec3::Zero();
  for (const Contact& contact : world.contact_world.contacts()) {
    if (contact.a == body.proxy && contact.b == other) force += contact.impulse / dt;
    if (contact.b == body.proxy && contact.a == other) force -= contact.impulse / dt;
  }
  return force;
}

/// True if the load of an object on a rigid body is no larger than when the body was found quiescent: loads on few
/// points then are spread by faces.
bool is_known_load(const WorldState& world, const Body& body, ProxyId other, double dt, bool stays) {
  constexpr double kSame = 0.1;
  const auto known = std::ranges::find(body.known_contact_loads, other, &ContactLoad::other);
  if (known == body.known_contact_loads.end()) return false;
  const double more = (load_of(world, body, other, dt) - known->force).norm();
  return more <= kSame * known->force.norm() || !could_deform(world, body, more, stays);
}

/// Adds the load of an object to those that a body is known to carry [N].
void add_known_load(Body& body, const ContactLoad& load) {
  const auto known = std::ranges::find(body.known_contact_loads, load.other, &ContactLoad::other);
  if (known == body.known_contact_loads.end()) return body.known_contact_loads.push_back(load);
  known->force += load.force;
  known->lost_in_impact += load.lost_in_impact;
}

/// Returns the energy that a contact took by stopping what came closer [J], 0 for one at rest.
double lost_in_impact(const WorldState& world, const Contact& contact, double dt) {
  return is_at_rest(world, contact, dt) ? 0 : 0.5 * contact.approach * std::abs(contact.impulse.dot(contact.normal));
}

/// Records the loads of deformable bodies in a substep of `dt` [s]; they keep the record when they become rigid.
void record_loads(WorldState& world, double dt) {
  for (Body& body : world.bodies)
    if (body.is_deformable()) body.known_contact_loads.clear();
  const auto note = [&](ProxyId object, const ContactLoad& load) {
    const BodyId id = world.body_of(object);
    if (id.valid() && world.bodies[id].is_deformable()) add_known_load(world.bodies[id], load);
  };
  for (const Contact& contact : std::as_const(world.contact_world).contacts()) {
    if (contact.impulse.isZero(0)) continue;
    const double lost = lost_in_impact(world, contact, dt);
    note(contact.a, {contact.b, contact.impulse / dt, lost});
    note(contact.b, {contact.a, -contact.impulse / dt, lost});
  }
}

/// True if a rigid or sleeping body must deform under a contact: one that could damage it, or its first.
bool must_deform(const WorldState& world, const Body& body, const Contact& contact, double dt) {
  if (body.ballistic) return !contact.impulse.isZero(0);
  const bool stays = is_at_rest(world, contact, dt);
  return could_deform(world, body, contact.impulse.norm() / dt, stays) &&
         !is_left_to_microsteps(world, body, contact) &&
         !is_known_load(world, body, contact.a == body.proxy ? contact.b : contact.a, dt, stays);
}

/// True if a body is immovable or rigid under its contacts and could deform.
bool may_deform(const Body& body) { return body.rigid ? !body.supported() : body.asleep; }

/// Makes rigid and sleeping bodies deformable that must deform under the impulses found; in hybrid steps
/// bonded ones are left to the microsteps of the next substep. Returns true if there were any.
bool make_struck_bodies_elastic(WorldState& world, double dt) {
  bool any = false;
  for (const Contact& contact : world.contact_world.contacts())
    for (ProxyId side : {contact.a, contact.b}) {
      const BodyId id = world.body_of(side);
      if (!id.valid() || !may_deform(world.bodies[id]) || !must_deform(world, world.bodies[id], contact, dt)) continue;
      if (is_held_by_bonds(world, world.bodies[id])) {
        const ProxyId other = side == contact.a ? contact.b : contact.a;
        std::erase_if(world.bodies[id].known_contact_loads,
                      [&](const ContactLoad& load) { return load.other == other; });
        add_known_load(world.bodies[id], {other, load_of(world, world.bodies[id], other, dt)});
        world.bodies[id].bonds_loaded = true;
        continue;
      }
      const bool slept = world.bodies[id].asleep;
      if (world.bodies[id].rigid) place_rigid_nodes(world.bodies[id], world.nodes, world.edges);
      make_elastic(world, world.bodies[id]);
      join_substep(world, world.bodies[id], slept, dt);
      any = true;
    }
  return any;
}

/// Passes the motions of bodies to the contact world, except for those that it moves as rigid ones itself: per BodyId.
void push_rigid_velocities(WorldState& world, const std::vector<bool>& moved = {}) {
  for (const Body& body : world.bodies) {
    if (body.asleep || body.supported() || (!moved.empty() && moved[body.id])) continue;
    const RigidMotion motion = body.rigid ? body.motion : motion_of(world, body);
    world.contact_world.set_velocity(body.proxy, motion.velocity, motion.angular_velocity);
  }
}

/// Returns the deformable bodies that the contact world moved as rigid ones, per BodyId.
std::vector<bool> taken_for_rigid(const WorldState& world, const TouchedBodies& touched) {
  std::vector<bool> taken(world.bodies.size(), false);
  for (const TouchedBody& of : touched.bodies) taken[of.body] = world.bodies[of.body].quasi_static;
  return taken;
}

void read_back_rigid_velocities(WorldState& world) {
  for (Body& body : world.bodies) {
    if (!body.rigid || body.asleep || body.supported()) continue;
    const RigidState state = world.contact_world.state(body.proxy);
    body.motion.velocity = state.velocity;
    body.motion.angular_velocity = state.angular_velocity;
  }
}

void replace_contacts(WorldState& world, const SpreadContacts& spread) {
  if (std::ranges::find(spread.replaced, true) == spread.replaced.end() && spread.added.empty()) return;
  world.contact_world.replace_contacts(spread.replaced, spread.added);
}

/// Foresees where soft bodies turn to in the substep.
void foresee_turns(const WorldState& world, TouchedBodies& touched, double dt) {
  for (TouchedBody& of : touched.bodies) foresee_turn(world, of, dt);
}

/// Returns, per ProxyId, true for the bodies in explicit dynamics: their contacts are left to the microsteps.
std::vector<bool> explicit_objects(const WorldState& world) {
  std::vector<bool> is_explicit(world.body_of_proxy.size(), false);
  for (const Body& body : world.bodies)
    if (body.explicit_state) is_explicit[body.proxy] = true;
  return is_explicit;
}

/// Adds contacts of objects that come together in the substep although detection listed none, except for those that
/// `leave` removes. Returns true if there are any.
bool add_unlisted_contacts(WorldState& world, double dt, const MeetingFilter& leave) {
  ContactWorld& contacts = world.contact_world;
  std::vector<ContactWorld::Meeting> meetings = std::as_const(contacts).unlisted_meetings(
      dt, min_impact_speed(world), impact_tolerance(world), explicit_objects(world));
  if (leave) leave(world, meetings);
  std::vector<Contact> added;
  for (const ContactWorld::Meeting& meeting : meetings)
    added.insert(added.end(), meeting.points.begin(), meeting.points.end());
  if (added.empty()) return false;
  contacts.replace_contacts(std::vector<bool>(contacts.contacts().size(), false), added);
  return true;
}

/// Finds the impulses on which all that touches agrees. Rigid and sleeping bodies that must deform under them do.
SolvedContacts solve_contacts(WorldState& world, double dt, const MeetingFilter& leave) {
  SolvedContacts solved{touched_bodies(world), {}};
  TouchedBodies& touched = solved.touched;
  fit_contacts(world, touched, world.contact_world.contacts());
  foresee_turns(world, touched, dt);
  keep_contacts(touched, world.contact_world.drop_near_misses(dt, approach_speeds(world, touched, dt)));
  solved.groups = solve_elastic_contacts(world, touched, dt);
  while (make_struck_bodies_elastic(world, dt) || add_unlisted_contacts(world, dt, leave)) {
    choose_quasi_static_bodies(world);  // groups have grown
    replace_contacts(world, spread_contacts(world, dt));
    const SolvedContacts earlier = std::exchange(solved, {touched_bodies(world), {}});
    place_contacts(world, touched, world.contact_world.contacts());
    foresee_turns(world, touched, dt);
    solved.groups = solve_elastic_contacts(world, touched, dt, earlier);
  }
  return solved;
}

void apply_corrections(WorldState& world) {
  for (Body& body : world.bodies) {
    // What is rigid is led to where its contacts leave it, and microsteps have contacts of their own.
    if (body.asleep || body.supported() || body.rigid || body.explicit_state) continue;
    const ContactWorld::Correction correction = world.contact_world.position_correction(body.proxy);
    if (correction.translation.isZero(0) && correction.rotation.isZero(0)) continue;
    world.energy.limited += body.motion.mass * world.model->scene.gravity.dot(correction.translation);
    const RigidMotion motion = motion_of(world, body);
    body.motion.center += correction.translation;
    carry(world, body, rotation_by(correction.rotation).toRotationMatrix(),
          {{motion.center, body.orientation}, motion.velocity, motion.angular_velocity},
          {{body.motion.center, body.orientation}, motion.velocity, motion.angular_velocity});
  }
}

}  // namespace

void place_proxies(WorldState& world) {
  for (Body& body : world.bodies) {
    if (body.asleep) continue;
    if (body.is_deformable()) follow_deformation(world, body);
    world.contact_world.set_state(body.proxy, proxy_state(world, body));
  }
}

ExternalForces external_forces(const WorldState& world, double dt) {
  ExternalForces forces = weights(world);
  add_load_forces(world, {world.time, world.time + dt}, forces);
  return forces;
}

void make_first_struck_elastic(WorldState& world, double duration) {
  const auto is_ballistic = [&](BodyId id) { return id.valid() && world.bodies[id].ballistic; };
  if (std::ranges::none_of(world.bodies, &Body::ballistic)) return;
  const auto matters = [&](BodyId a, BodyId b) { return is_ballistic(a) || is_ballistic(b); };
  for (const auto& impact : expected_impacts(world, duration, matters))
    for (const BodyId id : {world.body_of(impact.a), world.body_of(impact.b)}) {
      if (!is_ballistic(id)) continue;
      place_rigid_nodes(world.bodies[id], world.nodes, world.edges);
      make_elastic(world, world.bodies[id]);
    }
}

void find_contacts(WorldState& world, double dt) {
  world.contact_world.detect(dt);  // before the prediction, by which all that rests is about to fall
  world.contact_world.drop_contacts_of(explicit_objects(world));
  choose_quasi_static_bodies(world);
  stop_waves(world);
}

std::vector<ElasticMove> resolve_contacts(WorldState& world, const std::vector<Vec3>& external, double dt,
                                          const MeetingFilter& leave) {
  wake_disturbed_bodies(world, dt);
  push_rigid_velocities(world);
  add_unlisted_contacts(world, dt, leave);
  choose_quasi_static_bodies(world);  // bodies woke, and groups have grown
  replace_contacts(world, spread_contacts(world, dt));
  SolvedContacts solved = solve_contacts(world, dt, leave);
  const BeforeContacts before =
      may_strain_far(world) ? BeforeContacts{world.nodes.velocities, world.edges.velocities, world.nodes.reactions}
                            : BeforeContacts();
  respond(world, solved.touched, dt);
  std::vector<ElasticMove> moves = resolve_large_strains(world, solved, external, before, dt);
  for (const TouchedBody& of : solved.touched.bodies)
    world.energy.contacts -= world.scratch.bodies[of.body].contact_work;
  push_rigid_velocities(world, taken_for_rigid(world, solved.touched));
  world.contact_world.advance(dt);
  read_back_rigid_velocities(world);
  account_rigid_contacts(world, dt);
  apply_corrections(world);
  record_loads(world, dt);
  add_contacts(world, world.output.contacts);
  const int contacts = static_cast<int>(world.contact_world.contacts().size());
  world.report.contacts = std::max(world.report.contacts, contacts);
  world.report.max_penetration = std::max(world.report.max_penetration, world.contact_world.max_penetration());
  return moves;
}

}  // namespace griffith
