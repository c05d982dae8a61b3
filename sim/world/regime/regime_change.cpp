#include "sim/world/regime/regime_change.h"

#include <algorithm>
#include <cmath>

#include "sim/world/bodies/bodies.h"
#include "sim/world/bodies/impact_speeds.h"
#include "sim/world/energy/energy_phase.h"
#include "sim/world/motion/elastic_phase.h"

namespace griffith {
namespace {

bool all_finite(const std::vector<Vec3>& values, const auto& ids) {
  return std::ranges::all_of(ids, [&](auto id) { return values[id].allFinite(); });
}

/// True if the body has a finite position.
bool is_placed(const WorldState& world, const Body& body) {
  return all_finite(world.nodes.positions, body.nodes) && all_finite(world.edges.offsets, body.edges) &&
         body.motion.center.allFinite() && body.motion.inertia.allFinite() && body.orientation.coeffs().allFinite();
}

bool is_sound(const WorldState& world, const Body& body) {
  return is_placed(world, body) && all_finite(world.nodes.velocities, body.nodes) &&
         all_finite(world.edges.velocities, body.edges) && body.motion.velocity.allFinite() &&
         body.motion.angular_velocity.allFinite();
}

}  // namespace

void set_ballistic(WorldState& world, Body& body, bool ballistic) {
  if (body.ballistic == ballistic) return;
  body.ballistic = ballistic;
  world.contact_world.set_impact_speed(body.proxy, ballistic ? 0 : examined_impact_speed(world, body));
}

void make_elastic(WorldState& world, Body& body) {
  world.contact_world.wake_up(body.proxy);
  const double before = elastic_energy(world, body);
  set_ballistic(world, body, false);
  body.rigid = body.asleep = false;
  body.quiet_steps = 0;
  body.rest.time = 0;
  update_elements(world, body);  // it has turned since
  world.energy.regime_change += before - elastic_energy(world, body);
}

void make_rigid(WorldState& world, Body& body) {
  body.rigid = true;
  fit_proxy(world, body);
  const Mat3 back = body.orientation.conjugate().toRotationMatrix();
  for (std::size_t i = 0; i < body.nodes.size(); ++i)
    body.reference_arms.col(i) = back * (world.nodes.positions[body.nodes[i]] - body.motion.center);
  body.reference_offsets.resize(3, static_cast<Eigen::Index>(body.edges.size()));
  for (std::size_t i = 0; i < body.edges.size(); ++i)
    body.reference_offsets.col(i) = back * world.edges.offsets[body.edges[i]];
}

void stop_vibration(WorldState& world, Body& body) {
  const double before = energy_of(world, body);
  clear_stress(body, world.elements, world.nodes);
  make_rigid(world, body);
  world.energy.regime_change += before - energy_of(world, body);
}

void place_rigid_nodes(const Body& body, NodeArrays& nodes, EdgeArrays& edges) {
  const RigidMotion& motion = body.motion;
  const Mat3 rotation = body.orientation.toRotationMatrix();
  for (std::size_t i = 0; i < body.nodes.size(); ++i) {
    const Vec3 arm = rotation * body.reference_arms.col(i);
    nodes.positions[body.nodes[i]] = motion.center + arm;
    nodes.velocities[body.nodes[i]] = motion.velocity + motion.angular_velocity.cross(arm);
  }
  for (std::size_t i = 0; i < body.edges.size(); ++i) {
    const EdgeId edge = body.edges[i];
    edges.offsets[edge] = rotation * body.reference_offsets.col(i);
    edges.velocities[edge] = motion.angular_velocity.cross(edges.offsets[edge]);
  }
}

void freeze(WorldState& world, Body& body) {
  ++world.report.non_finite_values;
  const double before = energy_of(world, body);
  if (body.supported())
    for (NodeId node : body.nodes) world.nodes.velocities[node] = world.nodes.reactions[node] = Vec3::Zero();
  clear_stress(body, world.elements, world.nodes);
  body.motion = motion_of(world, body);
  make_rigid(world, body);
  if (std::isfinite(before)) world.energy.limited += before - energy_of(world, body);
}

void freeze_if_broken_down(WorldState& world, Body& body) {
  if (body.asleep || is_sound(world, body)) return;
  if (!is_placed(world, body)) {
    const Pose last = world.contact_world.state(body.proxy).pose;
    body.motion.center = last.translation;
    body.orientation = last.rotation;
    place_rigid_nodes(body, world.nodes, world.edges);
  }
  for (NodeId node : body.nodes) world.nodes.velocities[node] = world.nodes.reactions[node] = Vec3::Zero();
  for (EdgeId edge : body.edges)
    if (!(world.edges.velocities[edge].setZero(), world.edges.offsets[edge].allFinite()))
      world.edges.offsets[edge].setZero();
  for (TetId tet : body.tets) world.elements.remove_undefined_strains(tet);
  freeze(world, body);
}

}  // namespace griffith
