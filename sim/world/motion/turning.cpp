#include "sim/world/motion/turning.h"

#include <Eigen/LU>

#include "sim/core/rotation.h"
#include "sim/world/bodies/bodies.h"

namespace griffith {

NodeVectors of_nodes(const Body& body, const std::vector<Vec3>& values) {
  NodeVectors columns(3, body.nodes.size());
  for (std::size_t i = 0; i < body.nodes.size(); ++i) columns.col(i) = values[body.nodes[i]];
  return columns;
}

Eigen::VectorXd masses_of(const WorldState& world, const Body& body) {
  Eigen::VectorXd masses(body.nodes.size());
  for (std::size_t i = 0; i < body.nodes.size(); ++i) masses[i] = world.nodes.masses[body.nodes[i]];
  return masses;
}

namespace {

/// Moves the edges of a body that turns by `turn` in a substep of `dt` [s]: they turn along, and what their velocities
/// have beside `spin` [rad/s] bends them. Velocities are left without what turning makes of them.
void turn_edges(const Body& body, const Vec3& spin, const Mat3& turn, double dt, EdgeArrays& edges) {
  for (const EdgeId edge : body.edges) {
    Vec3 &offset = edges.offsets[edge], &velocity = edges.velocities[edge];
    const Vec3 bending = velocity - spin.cross(offset);
    offset = turn * (offset + dt * bending);
    velocity = turn * bending;
  }
}

}  // namespace

Turning turning_of(const WorldState& world, const Body& body, const Pivot& pivot) {
  return turning_about(pivot, of_nodes(body, world.nodes.positions), of_nodes(body, world.nodes.velocities),
                       masses_of(world, body));
}

void carry(WorldState& world, const Body& body, const Mat3& turn, const RigidState& before, const RigidState& after) {
  const Vec3 velocity = after.velocity - before.velocity, spin = after.angular_velocity - before.angular_velocity;
  for (const NodeId node : body.nodes) {
    const Vec3 arm = world.nodes.positions[node] - before.pose.translation;
    world.nodes.velocities[node] += velocity + spin.cross(arm);
    world.nodes.positions[node] = after.pose.translation + turn * arm;
    world.nodes.velocities[node] = turn * (world.nodes.velocities[node] - after.velocity) + after.velocity;
  }
  for (const EdgeId edge : body.edges) {
    Vec3 &offset = world.edges.offsets[edge], &bending = world.edges.velocities[edge];
    bending = turn * (bending + spin.cross(offset));
    offset = (turn * offset).eval();
  }
}

void move_free(WorldState& world, const Body& body, double dt) {
  const RigidMotion before = motion_of(world, body);
  const Mat3 turn = free_turn(before.inertia, before.angular_velocity, dt);
  const Vec3 center = before.center + dt * before.velocity;
  for (NodeId node : body.nodes) {
    Vec3 &position = world.nodes.positions[node], &velocity = world.nodes.velocities[node];
    const Vec3 deforming = velocity - before.velocity_at(position);
    position = center + turn * (position - before.center + dt * deforming);
    velocity = turn * deforming;
  }
  turn_edges(body, before.angular_velocity, turn, dt, world.edges);
  const RigidMotion after = motion_of(world, body);
  const Vec3 spin = after.inertia.inverse() * (before.inertia * before.angular_velocity);
  for (NodeId node : body.nodes)
    world.nodes.velocities[node] += before.velocity + spin.cross(world.nodes.positions[node] - center);
  add_spin_to_edges(body, spin, world.edges);
}

namespace {

/// Returns the mean spin of a body in a substep of `dt` [s] after which it has `spin` [rad/s]: with half of the change
/// by `external` forces, so that it swings without gain or loss (position Verlet). A body with contacts moves by the
/// velocity that avoids penetration.
Vec3 mean_spin(const WorldState& world, const Body& body, const Pivot& pivot, const Vec3& spin,
               const std::vector<Vec3>& external, double dt) {
  if (world.scratch.bodies[body.id].contact_work != 0) return spin;
  constexpr int kIterations = 3;
  const NodeVectors positions = of_nodes(body, world.nodes.positions), forces = of_nodes(body, external);
  const Eigen::VectorXd masses = masses_of(world, body);
  Vec3 gained = Vec3::Zero();
  for (int i = 0; i < kIterations; ++i)
    gained = dt * swing_acceleration(pivot, positions, masses, forces, 0.5 * dt * (spin - gained));
  return spin - 0.5 * gained;
}

}  // namespace

void move_swinging(WorldState& world, const Body& body, const Pivot& pivot, const std::vector<Vec3>& external,
                   double dt) {
  const Turning before = turning_of(world, body, pivot);
  const Vec3 mean = mean_spin(world, body, pivot, before.spin, external, dt);
  const Mat3 turn =
      pivot.axes.cols() == 3 ? free_turn(before.inertia, mean, dt) : rotation_by(dt * mean).toRotationMatrix();
  for (NodeId node : body.nodes) {
    Vec3 &position = world.nodes.positions[node], &velocity = world.nodes.velocities[node];
    const Vec3 from = position, deforming = velocity - before.spin.cross(position - pivot.place);
    position = pivot.place + turn * (position - pivot.place + dt * deforming);
    velocity = turn * deforming;
    const NodeConstraint& constraint = world.nodes.constraints[node];
    position = from + constraint.allowed * (position - from);
  }
  turn_edges(body, before.spin, turn, dt, world.edges);
  const Turning after = turning_of(world, body, pivot);
  const Mat3 turned = pivot.axes.cols() == 3 ? Mat3(Mat3::Identity()) : turn;
  const Vec3 spin = spin_about(pivot, after.inertia, turned * (before.inertia * before.spin));
  for (NodeId node : body.nodes) {
    Vec3& velocity = world.nodes.velocities[node];
    velocity =
        world.nodes.constraints[node].allowed * (velocity + spin.cross(world.nodes.positions[node] - pivot.place));
  }
  add_spin_to_edges(body, spin, world.edges);
}

}  // namespace griffith
