#include "sim/world/motion/motion_phase.h"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <functional>
#include <optional>

#include "sim/core/parallel.h"
#include "sim/core/rotation.h"
#include "sim/world/bodies/bodies.h"
#include "sim/world/bodies/supported_motion.h"
#include "sim/world/contact/contact_phase.h"
#include "sim/world/energy/energy_phase.h"
#include "sim/world/motion/elastic_phase.h"
#include "sim/world/motion/turning.h"
#include "sim/world/regime/regime_change.h"
#include "sim/world/state/world_state.h"

namespace griffith {
namespace {

/// Returns the displacement of a rigid body, to where its contacts leave it [m]. Fast bodies stop at contacts, or they
/// would pass through thin bodies. Pieces of one body, similar in size, may pass through one another.
Vec3 way_of(const WorldState& world, const Body& body, double dt) {
  constexpr double kSlowFraction = 0.25;  // of its size: so much overlap would still be found
  const double slow = kSlowFraction * body.extent;
  const Vec3 displacement = dt * body.motion.velocity + world.contact_world.position_correction(body.proxy).translation;
  if (displacement.norm() < slow) return displacement;
  const auto stops = [&](ProxyId proxy) {
    constexpr double kMuchLarger = 2;
    const BodyId id = world.body_of(proxy);
    return !id.valid() || world.bodies[id].scene_body != body.scene_body ||
           world.bodies[id].extent > kMuchLarger * body.extent;
  };
  return world.contact_world.swept_center(body.proxy, dt, slow, stops) -
         world.contact_world.state(body.proxy).pose.translation;
}

/// Moves a body that does not deform: its motion leads, its nodes follow.
void move_rigid(WorldState& world, Body& body, double dt) {
  if (body.supported()) return;  // frozen: its supports hold it
  RigidMotion& motion = body.motion;
  const ContactWorld::Correction correction = world.contact_world.position_correction(body.proxy);
  const Mat3 turn = free_turn(motion.inertia, motion.angular_velocity, dt) * rotation_by(correction.rotation);
  const Vec3 angular_momentum = motion.inertia * motion.angular_velocity;
  const Vec3 displacement = way_of(world, body, dt), mean = motion.velocity + correction.translation / dt;
  motion.center += displacement;
  motion.velocity += world.contact_world.velocity_after(mean, displacement, dt) - mean;
  motion.inertia = turn * motion.inertia * turn.transpose();
  motion.angular_velocity = motion.inertia.inverse() * angular_momentum;
  body.orientation = (Quat(turn) * body.orientation).normalized();
  place_rigid_nodes(body, world.nodes, world.edges);
}

/// Returns the work on the body in a substep that may increase its energy: by external forces, supports and contacts
/// [J].
double work_done(const WorldState& world, const Body& body, const std::vector<Vec3>& external, double dt) {
  double work = world.scratch.bodies[body.id].contact_work;
  for (NodeId node : body.nodes) work += dt * external[node].dot(world.nodes.velocities[node]);
  for (NodeId node : body.system->supports())
    work += dt * world.nodes.reactions[node].dot(world.nodes.velocities[node]);
  return work;
}

/// Motion of a body as a whole within its supports: about its center of mass or a pivot.
struct FreeMotion {
  Vec3 place = Vec3::Zero(), velocity = Vec3::Zero(), spin = Vec3::Zero();
  Vec3 velocity_at(const Vec3& position) const { return velocity + spin.cross(position - place); }
};

/// Returns no motion if supports hold the body more firmly.
std::optional<FreeMotion> free_motion_of(const WorldState& world, const Body& body) {
  if (!body.supported()) {
    const RigidMotion motion = motion_of(world, body);
    return FreeMotion{motion.center, motion.velocity, motion.angular_velocity};
  }
  if (const std::optional<Pivot> pivot = pivot_of(world, body))
    return FreeMotion{pivot->place, Vec3::Zero(), turning_of(world, body, *pivot).spin};
  return std::nullopt;
}

/// Returns the part of a node's velocity that does not deform a body with this motion as a whole; without one, that of
/// its supports together.
std::function<Vec3(NodeId)> rigid_velocity_of(const WorldState& world, const Body& body,
                                              const std::optional<FreeMotion>& motion) {
  if (motion)
    return [&world, motion = *motion](NodeId node) { return motion.velocity_at(world.nodes.positions[node]); };
  return [&world, carried = common_velocity(body.system->supports(), world.nodes.constraints)](NodeId node) {
    const NodeConstraint& constraint = world.nodes.constraints[node];
    return Vec3(constraint.velocity + constraint.allowed * carried);
  };
}

/// Restores a snapshot.
void restore(WorldState& world, const Body& body, const BodySnapshot& taken) {
  for (std::size_t i = 0; i < body.nodes.size(); ++i) {
    world.nodes.positions[body.nodes[i]] = taken.positions[i];
    world.nodes.velocities[body.nodes[i]] = taken.velocities[i];
  }
  for (std::size_t i = 0; i < body.edges.size(); ++i) {
    world.edges.offsets[body.edges[i]] = taken.offsets[i];
    world.edges.velocities[body.edges[i]] = taken.edge_velocities[i];
  }
  restore_plastic_strains(world, body, taken);
}

void move_nodes(WorldState& world, const Body& body, const std::vector<Vec3>& external, double dt) {
  if (!world.integrates_explicitly()) {
    if (!body.supported()) return move_free(world, body, dt);
    if (const std::optional<Pivot> pivot = pivot_of(world, body))
      return move_swinging(world, body, *pivot, external, dt);
  }
  for (NodeId node : body.nodes) world.nodes.positions[node] += dt * world.nodes.velocities[node];
  for (EdgeId edge : body.edges) world.edges.offsets[edge] += dt * world.edges.velocities[edge];
}

}  // namespace

double energy_of_strain(const WorldState& world, const Body& body, double strain) {
  const Material& material = world.material_of(body);
  return 0.5 * material.young_modulus * strain * strain * body.motion.mass / material.density;
}

namespace {

/// Returns the energy that a body had when the substep began, and what it is given at its present velocities [J].
double energy_with_work(const WorldState& world, const Body& body, const std::vector<Vec3>& external, double dt) {
  return world.scratch.bodies[body.id].energy + work_done(world, body, external, dt);
}

/// True if a body has more energy than it may have, beyond rounding [J].
bool has_more_than(const WorldState& world, const Body& body, double allowed) {
  constexpr double kTolerance = 1e-5;
  const double energy = world.scratch.bodies[body.id].energy;
  const double noise = energy_of_strain(world, body, 1e-12) + kTolerance * (energy + allowed);
  return mechanical_energy(world, body) > allowed + noise;
}

/// Moves an elastic body by the velocities of this step and takes its stress. Returns how: what it would give more
/// energy than it had and was given moves by the nonlinear one.
ElasticMove move_elastic(WorldState& world, Body& body, const BodySnapshot& before, const std::vector<Vec3>& external,
                         ElasticMove move, double dt) {
  const bool checked = !world.integrates_explicitly();
  const double allowed = checked ? energy_with_work(world, body, external, dt) : 0;
  move_nodes(world, body, external, dt);
  update_elements(world, body);
  if (!checked || !has_more_than(world, body, allowed)) return move;
  return move_nonlinearly(world, body, before, external, dt) ? ElasticMove::nonlinear : ElasticMove::unconverged;
}

/// Takes the motion of a body as a whole out of its deforming velocities.
void leave_deforming_velocities(WorldState& world, const Body& body) {
  const std::optional<FreeMotion> motion = free_motion_of(world, body);
  if (!motion) return;
  SubstepStart& start = world.scratch.substep_start;
  for (NodeId node : body.nodes) start.deforming_velocities[node] -= motion->velocity_at(world.nodes.positions[node]);
  for (EdgeId edge : body.edges) start.deforming_edge_velocities[edge] -= motion->spin.cross(world.edges.offsets[edge]);
}

}  // namespace

bool would_gain_energy(WorldState& world, const Body& body, const std::vector<Vec3>& external, double dt) {
  const BodySnapshot before = snapshot(world, body);
  const double allowed = energy_with_work(world, body, external, dt);
  move_nodes(world, body, external, dt);
  update_elements(world, body);
  const bool gains = has_more_than(world, body, allowed);
  restore(world, body, before);
  update_elements(world, body);
  return gains;
}

Wrench wrench_of(const WorldState& world, const Body& body, const std::vector<Vec3>& forces) {
  Wrench wrench;
  for (NodeId node : body.nodes) {
    wrench.force += forces[node];
    wrench.torque += (world.nodes.positions[node] - body.motion.center).cross(forces[node]);
  }
  return wrench;
}

double kinetic_energy_of(const WorldState& world, const Body& body) {
  double energy = kinetic_energy_of_edges(world, body.edges);
  for (NodeId node : body.nodes) energy += 0.5 * world.nodes.masses[node] * world.nodes.velocities[node].squaredNorm();
  return energy;
}

double mechanical_energy(const WorldState& world, const Body& body) {
  return elastic_energy(world, body) + kinetic_energy_of(world, body);
}

void move_without_deforming(WorldState& world, const Body& body, const BodySnapshot& before,
                            const std::vector<Vec3>& external, double dt) {
  restore(world, body, before);
  keep_whole_motion(world, body);
  move_nodes(world, body, external, dt);
}

void restore_angular_momentum(WorldState& world, const Body& body, const BodySnapshot& before) {
  if (body.supported()) return;
  const auto count = static_cast<Eigen::Index>(body.nodes.size());
  NodeVectors positions(3, count), velocities(3, count);
  for (Eigen::Index i = 0; i < count; ++i) {
    positions.col(i) = before.positions[i];
    velocities.col(i) = before.velocities[i];
  }
  const RigidMotion first = rigid_motion(positions, velocities, masses_of(world, body));
  restore_spin(world, body, first, motion_of(world, body));
}

void slow_deformation(WorldState& world, const Body& body, double fraction) {
  const std::optional<FreeMotion> motion = free_motion_of(world, body);
  const std::function<Vec3(NodeId)> whole_velocity = rigid_velocity_of(world, body, motion);
  const Vec3 spin = motion ? motion->spin : Vec3::Zero();
  const auto slow = [fraction](Vec3& velocity, const Vec3& whole) { velocity = whole + fraction * (velocity - whole); };
  for (NodeId node : body.nodes) slow(world.nodes.velocities[node], whole_velocity(node));
  for (EdgeId edge : body.edges) slow(world.edges.velocities[edge], spin.cross(world.edges.offsets[edge]));
}

double deforming_work(const WorldState& world, const Body& body, const std::vector<Vec3>& impulses) {
  const std::optional<FreeMotion> motion = free_motion_of(world, body);
  const std::function<Vec3(NodeId)> whole_velocity = rigid_velocity_of(world, body, motion);
  double work = 0;
  for (NodeId node : body.nodes) work += impulses[node].dot(world.nodes.velocities[node] - whole_velocity(node));
  return work;
}

void stop_deforming(WorldState& world, const Body& body) {
  const double before = kinetic_energy_of(world, body);
  keep_whole_motion(world, body);
  world.energy.regime_change += before - kinetic_energy_of(world, body);
}

void predict_rigid(const WorldState& world, Body& body, const std::vector<Vec3>& forces, double dt, RigidStart& start) {
  if (body.supported()) return;  // frozen: its supports hold it
  const auto [force, torque] = wrench_of(world, body, forces);
  RigidMotion& motion = body.motion;
  const double damping = 1 + dt * world.material_of(body).mass_damping;
  start.force = force;
  start.torque = torque;
  start.falls = true;
  motion.velocity = (motion.velocity + dt / motion.mass * force) / damping;
  motion.angular_velocity = (motion.angular_velocity + dt * (motion.inertia.inverse() * torque)) / damping;
}

void move_bodies(WorldState& world, const std::vector<Vec3>& external, std::vector<ElasticMove> moves, double dt) {
  world.scratch.substep_start.deforming_velocities = world.nodes.velocities;
  world.scratch.substep_start.deforming_edge_velocities = world.edges.velocities;
  std::vector<EnergyAccount> spent(world.bodies.size());
  parallel_for(static_cast<int>(world.bodies.size()), 1, [&](int begin, int end) {
    for (int i = begin; i < end; ++i) {
      Body& body = world.bodies[i];
      if (body.asleep || body.explicit_state) continue;
      if (body.rigid) {
        const RigidMotion before = body.motion;
        move_rigid(world, body, dt);
        spent[i] = spent_in_rigid_move(world, body, before, dt);
      } else {
        const BodySnapshot before = snapshot(world, body);
        leave_deforming_velocities(world, body);
        const ElasticWorks works = elastic_works(world, body, dt);
        moves[body.id] = move_elastic(world, body, before, external, moves[body.id], dt);
        spent[i] = spent_in_move(world, body, before, works, external, dt, moves[body.id]);
        world.scratch.bodies[i].damped = spent[i].time_integration;
        update_motion(world, body);
      }
    }
  });
  for (std::size_t i = 0; i < world.bodies.size(); ++i) {
    Body& body = world.bodies[i];
    if (!body.asleep && !body.explicit_state) world.energy += spent[i];
    freeze_if_broken_down(world, body);
    world.report.unconverged_motions += moves[body.id] == ElasticMove::unconverged;
    if (!body.is_deformable()) continue;
    for (TetId tet : body.tets) world.report.inverted_tets += world.elements.states[tet].inverted;
  }
  place_proxies(world);
}

}  // namespace griffith
