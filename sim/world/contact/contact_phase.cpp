#include "sim/world/contact/contact_phase.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "sim/core/parallel.h"
#include "sim/core/rotation.h"
#include "sim/solver/contact_response.h"
#include "sim/solver/rigid_motion.h"
#include "sim/world/bodies/bodies.h"
#include "sim/world/bodies/expected_impacts.h"
#include "sim/world/contact/elastic_contacts.h"
#include "sim/world/contact/face_contacts.h"
#include "sim/world/contact/large_strains.h"
#include "sim/world/contact/pressure_distribution.h"
#include "sim/world/contact/quasi_static.h"
#include "sim/world/contact/touched_body.h"
#include "sim/world/energy/energy_phase.h"
#include "sim/world/impacts/struck_bodies.h"
#include "sim/world/motion/elastic_phase.h"
#include "sim/world/motion/motion_phase.h"
#include "sim/world/output/publish.h"
#include "sim/world/regime/regime_change.h"
#include "sim/world/regime/rest_phase.h"
#include "sim/world/state/world_state.h"

namespace griffith {
namespace {

/// True if a force could bring a rigid piece near its strength somewhere, or deform it visibly.
bool could_deform(const WorldState& world, const Body& body, double force) {
  constexpr double kWakingFraction = 0.25;
  if (body.tets.size() == 1) return false;
  const double stress = force / (body.element_size * body.element_size);
  return stress > std::min(kWakingFraction * min_breaking_stress(world, body, true), visible_stress(world, body));
}

/// True if the damage by a contact was predicted before the step: impacts have their own phase, and their mean force in
/// a long step does not predict it. Bodies too soft for microsteps are left to the implicit step.
bool is_left_to_microsteps(const WorldState& world, const Body& body, const Contact& contact) {
  return world.model->scene.simulation.integrator == Integrator::hybrid && contact.approach > min_impact_speed(world) &&
         (!deforms_visibly(world, body) || suits_microsteps(world, body, 0));
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
bool is_known_load(const WorldState& world, const Body& body, ProxyId other, double dt) {
  constexpr double kSame = 0.1;
  const auto known = std::ranges::find(body.known_contact_loads, other, &ContactLoad::other);
  if (known == body.known_contact_loads.end()) return false;
  const double more = (load_of(world, body, other, dt) - known->force).norm();
  return more <= kSame * known->force.norm() || !could_deform(world, body, more);
}

/// Adds the load of an object to those that a body is known to carry [N].
void add_known_load(Body& body, ProxyId other, const Vec3& force) {
  const auto known = std::ranges::find(body.known_contact_loads, other, &ContactLoad::other);
  known == body.known_contact_loads.end() ? body.known_contact_loads.push_back({other, force})
                                          : void(known->force += force);
}

/// Records the loads of deformable bodies in a substep of `dt` [s]; they keep the record when they become rigid.
void record_loads(WorldState& world, double dt) {
  for (Body& body : world.bodies)
    if (body.is_deformable()) body.known_contact_loads.clear();
  const auto note = [&](ProxyId object, ProxyId other, const Vec3& force) {
    const BodyId id = world.body_of(object);
    if (id.valid() && world.bodies[id].is_deformable()) add_known_load(world.bodies[id], other, force);
  };
  for (const Contact& contact : std::as_const(world.contact_world).contacts()) {
    if (contact.impulse.isZero(0)) continue;
    note(contact.a, contact.b, contact.impulse / dt);
    note(contact.b, contact.a, -contact.impulse / dt);
  }
}

/// True if a rigid or sleeping body must deform under a contact: one that could damage it, or its first.
bool must_deform(const WorldState& world, const Body& body, const Contact& contact, double dt) {
  if (body.ballistic) return !contact.impulse.isZero(0);
  return could_deform(world, body, contact.impulse.norm() / dt) && !is_left_to_microsteps(world, body, contact) &&
         !is_known_load(world, body, contact.a == body.proxy ? contact.b : contact.a, dt);
}

/// True if a body is immovable or rigid under its contacts and could deform.
bool may_deform(const Body& body) { return body.rigid ? !body.supported() : body.asleep; }

/// Makes rigid and sleeping bodies deformable that must deform under the impulses found; bonded ones are left to the
/// microsteps of the next substep, where bonds act. Returns true if there were any.
bool make_struck_bodies_elastic(WorldState& world, double dt) {
  bool any = false;
  for (const Contact& contact : world.contact_world.contacts())
    for (ProxyId side : {contact.a, contact.b}) {
      const BodyId id = world.body_of(side);
      if (!id.valid() || !may_deform(world.bodies[id]) || !must_deform(world, world.bodies[id], contact, dt)) continue;
      if (world.bodies[id].bonded) {
        const ProxyId other = side == contact.a ? contact.b : contact.a;
        std::erase_if(world.bodies[id].known_contact_loads,
                      [&](const ContactLoad& load) { return load.other == other; });
        add_known_load(world.bodies[id], other, load_of(world, world.bodies[id], other, dt));
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

/// Returns the velocity changes of an elastic body's rows by nodal impulses, each node on its own.
NodeVectors respond_explicitly(WorldState& world, const Body& body, double dt, const std::vector<Vec3>& impulses) {
  NodeArrays& nodes = world.nodes;
  NodeVectors change = body.system->gather(impulses);
  const std::span<const NodeId> rows = body.system->nodes();
  for (std::size_t row = 0; row < rows.size(); ++row) {
    const NodeId node = rows[row];
    change.col(row) = (nodes.constraints[node].allowed * change.col(row) / nodes.masses[node]).eval();
  }
  for (NodeId node : body.system->supports())
    nodes.reactions[node] -= (impulses[node] - nodes.constraints[node].allowed * impulses[node]) / dt;
  return change;
}

/// Adds what its contacts did to the velocities of a body.
void add_changes(WorldState& world, const TouchedBody& touched) {
  const std::span<const NodeId> nodes = world.bodies[touched.body].system->nodes();
  for (std::size_t row = 0; row < nodes.size(); ++row) world.nodes.velocities[nodes[row]] += touched.change.col(row);
  const std::span<const EdgeId> edges = world.bodies[touched.body].system->edges();
  for (std::size_t i = 0, row = nodes.size(); i < edges.size(); ++i, ++row)
    world.edges.velocities[edges[i]] += touched.change.col(row);
}

/// Impulses on a body and where they act.
struct LoadedBody {
  TouchedBody at;
  Eigen::Matrix3Xd impulses;  ///< one column a point [N·s]
};

/// Adds the impulses at the contacts of an object, except those that are replaced.
void add_impulses(std::span<const Contact> contacts, const std::vector<bool>& replaced, const TouchedBody& touched,
                  const ElasticObject& object, LoadedBody& loaded) {
  for (std::size_t k = 0; k < object.contacts.size(); ++k) {
    if (replaced[object.contacts[k]]) continue;
    const Contact& contact = contacts[object.contacts[k]];
    loaded.impulses.col(static_cast<Eigen::Index>(loaded.at.points.size())) =
        contact.a == object.object ? contact.impulse : Vec3(-contact.impulse);
    loaded.at.points.push_back(touched.points[k]);
  }
}

/// Adds the impulses at nodes of an object.
void add_spread_impulses(const WorldState& world, const std::vector<Contact>& spread, ProxyId object,
                         LoadedBody& loaded) {
  std::optional<SurfaceSearch> surface;
  for (const Contact& contact : spread) {
    if (contact.a != object && contact.b != object) continue;
    const NodeId node = contact.a == object ? contact.node_a : contact.node_b;
    if (!node.valid() && !surface) surface.emplace(world, world.bodies[loaded.at.body]);
    loaded.impulses.col(static_cast<Eigen::Index>(loaded.at.points.size())) =
        contact.a == object ? contact.impulse : Vec3(-contact.impulse);
    loaded.at.points.push_back(node.valid() ? touched_node(world, node, contact.position)
                                            : touched_point(world, *surface, contact.position));
  }
}

LoadedBody loads_on(const WorldState& world, const TouchedBody& touched, const ElasticObject& object,
                    const SpreadContacts& spread) {
  const std::span<const Contact> contacts = world.contact_world.contacts();
  LoadedBody loaded{{touched.body, {}, {}, {}}, {}};
  loaded.impulses.resize(3, static_cast<Eigen::Index>(object.contacts.size() + spread.added.size()));
  add_impulses(contacts, spread.replaced, touched, object, loaded);
  if (world.bodies[touched.body].quasi_static) add_spread_impulses(world, spread.added, object.object, loaded);
  loaded.impulses.conservativeResize(Eigen::NoChange, static_cast<Eigen::Index>(loaded.at.points.size()));
  return loaded;
}

/// Moves a body by the impulses at its contacts.
void respond(WorldState& world, TouchedBody& touched, const LoadedBody& loaded, double dt) {
  Body& body = world.bodies[touched.body];
  if (loaded.impulses.isZero(0)) return;
  std::vector<Vec3>& nodal = world.scratch.contact_impulses;
  add_nodal_impulses(world, loaded.at, loaded.impulses, nodal);
  if (body.quasi_static) {
    const ImplicitStep step = implicit_step(world, body, dt);
    touched.change = respond_alone(deformable_inertia(world, body, dt), body.system->gather(nodal),
                                   step.relative_residual, step.max_iterations);
  }
  if (world.integrates_explicitly()) {
    touched.change = respond_explicitly(world, body, dt, nodal);
  } else {
    body.system->project(touched.change);
    body.system->add_reactions(dt, nodal, world.nodes.constraints, touched.change, world.nodes.reactions);
  }
  add_changes(world, touched);
  if (body.quasi_static && !reaches_equilibrium(world, body, dt)) keep_whole_motion(world, body);
  world.scratch.bodies[body.id].contact_work = loaded.impulses.cwiseProduct(point_velocities(world, loaded.at)).sum();
}

void respond(WorldState& world, TouchedBodies& touched, double dt) {
  world.scratch.contact_impulses.assign(world.nodes.positions.size(), Vec3::Zero());
  for (const TouchedBody& of : touched.bodies) world.scratch.bodies[of.body].contact_work = 0;
  const SpreadContacts spread = spread_impulses(world);
  parallel_for(static_cast<int>(touched.bodies.size()), 1, [&](int begin, int end) {
    for (int i = begin; i < end; ++i)
      respond(world, touched.bodies[i], loads_on(world, touched.bodies[i], touched.objects[i], spread), dt);
  });
  for (const TouchedBody& of : touched.bodies) world.energy.contacts -= world.scratch.bodies[of.body].contact_work;
}

void apply_corrections(WorldState& world) {
  for (Body& body : world.bodies) {
    if (body.asleep || body.supported() || body.rigid) continue;  // what is rigid is led to where its contacts leave it
    const ContactWorld::Correction correction = world.contact_world.position_correction(body.proxy);
    if (correction.translation.isZero(0) && correction.rotation.isZero(0)) continue;
    const Mat3 turn = rotation_by(correction.rotation).toRotationMatrix();
    const Vec3 center = body.motion.center;
    body.motion.center += correction.translation;
    world.energy.limited += body.motion.mass * world.model->scene.gravity.dot(correction.translation);
    for (NodeId node : body.nodes) {
      Vec3& position = world.nodes.positions[node];
      position = body.motion.center + turn * (position - center);
    }
    for (EdgeId edge : body.edges) world.edges.offsets[edge] = (turn * world.edges.offsets[edge]).eval();
  }
}

void replace_contacts(WorldState& world, const SpreadContacts& spread) {
  if (!spread.added.empty()) world.contact_world.replace_contacts(spread.replaced, spread.added);
}

/// Finds the impulses on which all that touches agrees. Rigid and sleeping bodies that must deform under them do.
TouchedBodies solve_contacts(WorldState& world, double dt) {
  TouchedBodies touched = touched_bodies(world);
  fit_contacts(world, touched, world.contact_world.contacts());
  keep_contacts(touched, world.contact_world.drop_near_misses(dt, approach_speeds(world, touched)));
  solve_elastic_contacts(world, touched, dt);
  while (make_struck_bodies_elastic(world, dt)) {
    replace_contacts(world, spread_contacts(world, dt));
    touched = touched_bodies(world);
    solve_elastic_contacts(world, touched, dt);
  }
  return touched;
}

}  // namespace

void place_proxies(WorldState& world) {
  for (Body& body : world.bodies) {
    if (body.asleep) continue;
    if (body.is_deformable() && deforms_visibly(world, body)) follow_deformation(world, body);
    world.contact_world.set_state(body.proxy, proxy_state(body));
  }
}

ExternalForces external_forces(const WorldState& world, double dt) {
  ExternalForces forces = weights(world);
  add_load_forces(world, {world.time, world.time + dt}, forces);
  return forces;
}

/// Leaves contacts of bodies in explicit dynamics to the microsteps.
void drop_contacts_of_explicit_bodies(WorldState& world) {
  std::vector<bool> is_explicit(world.body_of_proxy.size(), false);
  for (const Body& body : world.bodies)
    if (body.explicit_state) is_explicit[body.proxy] = true;
  world.contact_world.drop_contacts_of(is_explicit);
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
  drop_contacts_of_explicit_bodies(world);
  choose_quasi_static_bodies(world);
}

namespace {

/// Lets elastic bodies respond to their contacts, soft ones by nonlinear steps. Returns how bodies will move.
std::vector<ElasticMove> respond_and_strain(WorldState& world, TouchedBodies& touched,
                                            const std::vector<Vec3>& external, double dt) {
  if (!may_strain_far(world)) {
    respond(world, touched, dt);
    return std::vector<ElasticMove>(world.bodies.size(), ElasticMove::linearized);
  }
  const std::vector<Vec3> free = world.nodes.velocities, reactions = world.nodes.reactions;
  const double spent = world.energy.contacts;
  respond(world, touched, dt);
  return resolve_large_strains(world, external, free, dt, [&] {
    world.nodes.reactions = reactions;
    world.energy.contacts = spent;
    solve_elastic_contacts(world, touched, dt);
    respond(world, touched, dt);
  });
}

}  // namespace

std::vector<ElasticMove> resolve_contacts(WorldState& world, const std::vector<Vec3>& external, double dt) {
  wake_disturbed_bodies(world, dt);
  replace_contacts(world, spread_contacts(world, dt));
  push_rigid_velocities(world);
  TouchedBodies touched = solve_contacts(world, dt);
  std::vector<ElasticMove> moves = respond_and_strain(world, touched, external, dt);
  push_rigid_velocities(world, taken_for_rigid(world, touched));
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
