#include "sim/world/phases/contact_phase.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "sim/core/parallel.h"
#include "sim/core/rotation.h"
#include "sim/solver/rigid_motion.h"
#include "sim/world/bodies/bodies.h"
#include "sim/world/contact_views.h"
#include "sim/world/energy/energy_phase.h"
#include "sim/world/phases/elastic_phase.h"
#include "sim/world/phases/expected_impacts.h"
#include "sim/world/phases/face_contacts.h"
#include "sim/world/phases/motion_phase.h"
#include "sim/world/phases/rest_phase.h"
#include "sim/world/phases/settle_contacts.h"
#include "sim/world/phases/touched_body.h"
#include "sim/world/world_state.h"

namespace griffith {
namespace {

/// Whether a force could bring a rigid piece near its strength somewhere.
bool could_hurt(const WorldState& world, const Body& body, double force) {
  constexpr double kWakingFraction = 0.25;
  if (body.tets.size() == 1) return false;
  const double stress = force / (body.element_size * body.element_size);
  return stress > kWakingFraction * min_breaking_stress(world, body, true);
}

/// Whether whoever is hurt by a contact was found before the step: blows have their own phase, and the mean force of a
/// blow in a long step says nothing.
bool is_left_to_shock(const WorldState& world, const Contact& contact) {
  return world.model->scene.simulation.integrator == Integrator::hybrid && contact.approach > min_impact_speed(world);
}

/// What another object does to a body in a substep of `dt` [N].
Vec3 load_of(const WorldState& world, const Body& body, ProxyId other, double dt) {
  Vec3 force = Vec3::Zero();
  for (const Contact& contact : world.contact_world.contacts()) {
    if (contact.a == body.proxy && contact.b == other) force += contact.impulse / dt;
    if (contact.b == body.proxy && contact.a == other) force -= contact.impulse / dt;
  }
  return force;
}

/// Whether what an object does to a rigid body is no more than it did when the body was seen to be calm: however much
/// rests on few points then, faces spread it.
bool is_harmless(const WorldState& world, const Body& body, ProxyId other, double dt) {
  constexpr double kSame = 0.1;
  const auto known = std::ranges::find(body.harmless, other, &ContactLoad::other);
  if (known == body.harmless.end()) return false;
  const double more = (load_of(world, body, other, dt) - known->force).norm();
  return more <= kSame * known->force.norm() || !could_hurt(world, body, more);
}

/// Notes what elastic bodies carry in a substep of `dt` [s]; once they are rigid it stands.
void record_loads(WorldState& world, double dt) {
  for (Body& body : world.bodies)
    if (body.sways()) body.harmless.clear();
  const auto note = [&](ProxyId object, ProxyId other, const Vec3& force) {
    const BodyId id = world.body_of(object);
    if (!id.valid() || !world.bodies[id].sways()) return;
    std::vector<ContactLoad>& loads = world.bodies[id].harmless;
    const auto known = std::ranges::find(loads, other, &ContactLoad::other);
    known == loads.end() ? loads.push_back({other, force}) : void(known->force += force);
  };
  for (const Contact& contact : std::as_const(world.contact_world).contacts()) {
    if (contact.impulse.isZero(0)) continue;
    note(contact.a, contact.b, contact.impulse / dt);
    note(contact.b, contact.a, -contact.impulse / dt);
  }
}

/// Whether a rigid or sleeping body has to sway under a contact: one that could hurt it, or the first that it meets.
bool must_give_way(const WorldState& world, const Body& body, const Contact& contact, double dt) {
  if (body.untouched) return !contact.impulse.isZero(0);
  if (is_left_to_shock(world, contact)) return false;
  return could_hurt(world, body, contact.impulse.norm() / dt) &&
         !is_harmless(world, body, contact.a == body.proxy ? contact.b : contact.a, dt);
}

/// Whether a body is as yet immovable or rigid under its contacts and need not be.
bool may_give_way(const Body& body) { return body.rigid ? !body.supported() : body.asleep; }

/// Makes rigid and sleeping bodies sway that must under the impulses found; whether there were any.
bool make_struck_bodies_elastic(WorldState& world, double dt) {
  bool any = false;
  for (const Contact& contact : world.contact_world.contacts())
    for (ProxyId side : {contact.a, contact.b}) {
      const BodyId id = world.body_of(side);
      if (!id.valid() || !may_give_way(world.bodies[id]) || !must_give_way(world, world.bodies[id], contact, dt))
        continue;
      if (world.bodies[id].rigid) place_rigid_nodes(world, world.bodies[id]);
      make_elastic(world, world.bodies[id]);
      join_substep(world, world.bodies[id], dt);
      any = true;
    }
  return any;
}

void push_rigid_velocities(WorldState& world) {
  for (const Body& body : world.bodies) {
    if (body.asleep || body.supported()) continue;
    const RigidMotion motion = body.rigid ? body.motion : motion_of(world, body);
    world.contact_world.set_velocity(body.proxy, motion.velocity, motion.angular_velocity);
  }
}

void read_back_rigid_velocities(WorldState& world) {
  for (Body& body : world.bodies) {
    if (!body.rigid || body.asleep || body.supported()) continue;
    const RigidState state = world.contact_world.state(body.proxy);
    body.motion.velocity = state.velocity;
    body.motion.angular_velocity = state.angular_velocity;
  }
}

/// Nodal impulses for impulses at a body's contact points. `nodal`: per node of the mesh; only the body's are written.
void set_nodal_impulses(const WorldState& world, const TouchedBody& touched, const Eigen::Matrix3Xd& impulses,
                        std::vector<Vec3>& nodal) {
  for (NodeId node : world.bodies[touched.body].nodes) nodal[node].setZero();
  add_nodal_impulses(world, touched, impulses, nodal);
}

/// Adds to `change` what further nodal impulses change in the velocities of an elastic body's nodes.
void respond_explicitly(WorldState& world, const Body& body, double dt, const std::vector<Vec3>& impulses,
                        NodeVectors& change) {
  NodeArrays& nodes = world.nodes;
  NodeVectors added = body.system->gather(impulses);
  for (Eigen::Index row = 0; row < added.cols(); ++row) {
    const NodeId node = body.system->nodes()[row];
    added.col(row) = (nodes.constraints[node].allowed * added.col(row) / nodes.masses[node]).eval();
  }
  for (NodeId node : body.system->supports())
    nodes.reactions[node] -= (impulses[node] - nodes.constraints[node].allowed * impulses[node]) / dt;
  change += added;
}

/// What all nodal impulses of the substep change in the velocities of an elastic body's nodes. `change`: by the
/// impulses that were there before.
SolveReport respond_implicitly(WorldState& world, Body& body, double dt, const std::vector<Vec3>& impulses,
                               NodeVectors& change) {
  NodeArrays& nodes = world.nodes;
  const SolveReport report = body.system->respond(implicit_step(world, body, dt), nodes.positions, impulses,
                                                  nodes.masses, nodes.constraints, change, edge_motion(world));
  read_back_reactions(world, body);
  return report;
}

/// Moves the nodes of a body by a share (0..1) of what its contacts did. From their free velocities, whatever was
/// there before: the momentum that a change of any size takes away is what it brought.
void set_velocities(WorldState& world, const TouchedBody& touched, double fraction) {
  const std::span<const NodeId> nodes = world.bodies[touched.body].system->nodes();
  for (std::size_t row = 0; row < nodes.size(); ++row)
    world.nodes.velocities[nodes[row]] = touched.free.col(row) + fraction * touched.change.col(row);
  const std::span<const EdgeId> edges = world.bodies[touched.body].system->edges();
  for (std::size_t i = 0, row = nodes.size(); i < edges.size(); ++i, ++row)
    world.edges.velocities[edges[i]] = touched.free.col(row) + fraction * touched.change.col(row);
}

/// Lets the body's nodes move as the impulses at its contacts want it. `added`: to those that it knows.
SolveReport respond(WorldState& world, TouchedBody& touched, double dt, const Eigen::Matrix3Xd& impulses,
                    const Eigen::Matrix3Xd& added, std::vector<Vec3>& nodal) {
  Body& body = world.bodies[touched.body];
  if (touched.change.size() == 0) {
    touched.free = body.system->gather(world.nodes.velocities, world.edges.velocities);
    touched.change = NodeVectors::Zero(3, touched.free.cols());
  }
  SolveReport report;
  if (world.integrates_explicitly()) {
    set_nodal_impulses(world, touched, added, nodal);
    respond_explicitly(world, body, dt, nodal, touched.change);
  } else {
    set_nodal_impulses(world, touched, impulses, nodal);
    report = respond_implicitly(world, body, dt, nodal, touched.change);
  }
  set_velocities(world, touched, 1);
  return report;
}

/// How far the body's answer to a change of impulses was from what its compliance told.
struct Response {
  SolveReport solve;
  bool matches_prediction = true;
};

/// Lets a body answer the impulses that its contacts have now, and learns from it: the response becomes exact under
/// these impulses, its compliance right for their direction.
Response update_response(WorldState& world, TouchedBody& touched, ElasticResponse& response, double dt, bool learns,
                         std::vector<Vec3>& nodal) {
  constexpr double kForeseen = 0.1, kNegligible = 0.25;
  Body& body = world.bodies[touched.body];
  const std::span<const Contact> contacts = world.contact_world.contacts();
  Eigen::Matrix3Xd impulses(3, touched.points.size());
  for (Eigen::Index k = 0; k < impulses.cols(); ++k) {
    const Contact& contact = contacts[response.contacts[k]];
    impulses.col(k) = contact.a == body.proxy ? contact.impulse : Vec3(-contact.impulse);
  }
  const Eigen::Matrix3Xd added = impulses - response.impulses;
  if (added.isZero(0)) return {};
  Response given{respond(world, touched, dt, impulses, added, nodal), true};
  const Eigen::Matrix3Xd velocities = point_velocities(world, touched), moved = velocities - response.velocities;
  const Eigen::Matrix3Xd expected = griffith::respond(response.compliance, added);
  const double negligible = kNegligible * dt * world.model->scene.gravity.norm() * std::sqrt(added.cols());
  given.matches_prediction = (moved - expected).norm() <= kForeseen * expected.norm() + negligible;
  const double ratio = moved.cwiseProduct(added).sum() / expected.cwiseProduct(added).sum();
  if (learns && ratio > 0 && !world.integrates_explicitly()) {
    const double factor = std::clamp(ratio * body.compliance_factor, 0.1, 100.0);
    response.compliance.scale(factor / body.compliance_factor);
    body.compliance_factor = factor;
  }
  response.impulses = impulses;
  response.velocities = velocities;
  return given;
}

/// All bodies answer; whether all did as foreseen.
bool update_responses(WorldState& world, TouchedBodies& touched, double dt, bool learns = true) {
  std::vector<Vec3> nodal(world.nodes.positions.size());
  std::vector<Response> responses(touched.bodies.size());
  parallel_for(static_cast<int>(responses.size()), 1, [&](int begin, int end) {
    for (int i = begin; i < end; ++i)
      responses[i] = update_response(world, touched.bodies[i], touched.responses[i], dt, learns, nodal);
  });
  bool matches_prediction = true;
  for (std::size_t i = 0; i < responses.size(); ++i) {
    count_solve(world, responses[i].solve);
    matches_prediction &= responses[i].matches_prediction;
  }
  return matches_prediction;
}

/// Takes back what would add energy.
void limit_energy(WorldState& world, TouchedBodies& touched, double dt) {
  const std::vector<double> factors = world.contact_world.limit_energy(dt, touched.responses);
  for (std::size_t i = 0; i < factors.size(); ++i) {
    if (touched.bodies[i].change.size() == 0) continue;
    const ElasticResponse& response = touched.responses[i];
    const Eigen::Matrix3Xd velocities =
        response.free_velocities + factors[i] * (response.velocities - response.free_velocities);
    double& work = world.bodies[touched.bodies[i].body].contact_work;
    work = factors[i] * response.impulses.cwiseProduct(velocities).sum();
    world.energy.contacts -= work;
    if (factors[i] == 1) continue;
    ++world.report.limited_impulses;
    set_velocities(world, touched.bodies[i], factors[i]);
  }
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

void solve_impulses(WorldState& world, const TouchedBodies& touched, double dt, bool again) {
  world.contact_world.solve(dt, touched.responses, again);
}

/// Impulses by what is known of elastic bodies before they answer.
void estimate_impulses(WorldState& world, TouchedBodies& touched, double dt, bool again) {
  parallel_for(static_cast<int>(touched.bodies.size()), 1, [&](int begin, int end) {
    for (int i = begin; i < end; ++i) prepare_response(world, touched.bodies[i], dt, touched.responses[i]);
  });
  solve_impulses(world, touched, dt, again);
}

/// Impulses that the rigid and the elastic agree on: what is elastic is known by an estimate first, then by its
/// answers.
TouchedBodies solve_contacts(WorldState& world, double dt) {
  constexpr int kMaxRounds = 3;
  TouchedBodies touched = touched_bodies(world);
  correct_distances(world, touched);
  drop_near_misses(world, touched, dt);
  estimate_impulses(world, touched, dt, false);
  while (make_struck_bodies_elastic(world, dt)) {
    spread_contacts(world);
    touched = touched_bodies(world);
    estimate_impulses(world, touched, dt, true);
  }
  for (int round = 1; !update_responses(world, touched, dt) && round < kMaxRounds; ++round)
    solve_impulses(world, touched, dt, true);
  if (!world.integrates_explicitly() && settle_contacts(world, touched, dt))
    update_responses(world, touched, dt, false);
  return touched;
}

}  // namespace

void place_proxies(WorldState& world) {
  for (const Body& body : world.bodies) {
    if (body.asleep) continue;
    RigidState state{{body.motion.center, body.orientation}, body.motion.velocity, body.motion.angular_velocity};
    if (body.supported()) state.velocity = state.angular_velocity = Vec3::Zero();
    world.contact_world.set_state(body.proxy, state);
  }
}

std::vector<Vec3> external_forces(const WorldState& world, double dt) {
  std::vector<Vec3> forces(world.nodes.positions.size());
  for (std::size_t i = 0; i < forces.size(); ++i) forces[i] = world.nodes.masses[i] * world.model->scene.gravity;
  add_load_forces(world, {world.time, world.time + dt}, forces);
  return forces;
}

/// What touches a body in shock is left to the microsteps.
void drop_contacts_of_shocks(WorldState& world) {
  std::vector<bool> in_shock(world.body_of_proxy.size(), false);
  for (const Body& body : world.bodies)
    if (body.shock) in_shock[body.proxy] = true;
  world.contact_world.drop_contacts_of(in_shock);
}

void make_first_struck_elastic(WorldState& world, double duration) {
  const auto is_untouched = [&](BodyId id) { return id.valid() && world.bodies[id].untouched; };
  if (std::ranges::none_of(world.bodies, &Body::untouched)) return;
  const auto matters = [&](BodyId a, BodyId b) { return is_untouched(a) || is_untouched(b); };
  for (const auto& impact : expected_impacts(world, duration, matters))
    for (const BodyId id : {world.body_of(impact.a), world.body_of(impact.b)}) {
      if (!is_untouched(id)) continue;
      place_rigid_nodes(world, world.bodies[id]);
      make_elastic(world, world.bodies[id]);
    }
}

void resolve_contacts(WorldState& world, double dt) {
  world.contact_world.detect(dt);  // before the prediction, by which all that rests is about to fall
  drop_contacts_of_shocks(world);
  wake_disturbed_bodies(world, dt);
  spread_contacts(world);
  push_rigid_velocities(world);
  TouchedBodies touched = solve_contacts(world, dt);
  limit_energy(world, touched, dt);
  push_rigid_velocities(world);
  world.contact_world.advance(dt);
  read_back_rigid_velocities(world);
  book_rigid_contacts(world, dt);
  apply_corrections(world);
  record_loads(world, dt);
  record_contacts(world);
  const int contacts = static_cast<int>(world.contact_world.contacts().size());
  world.report.contacts = std::max(world.report.contacts, contacts);
  world.report.max_penetration = std::max(world.report.max_penetration, world.contact_world.max_penetration());
}

}  // namespace griffith
