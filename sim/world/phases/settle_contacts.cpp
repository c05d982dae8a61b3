#include "sim/world/phases/settle_contacts.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <utility>

#include "sim/core/parallel.h"
#include "sim/world/phases/elastic_phase.h"
#include "sim/world/world_state.h"

namespace griffith {
namespace {

/// How a node is held by what it touches.
enum class Hold { none, slides, sticks };

/// A node on something that does not move.
struct SettledNode {
  int contact = 0;       ///< index into the contacts
  int row = 0;           ///< of the body's system
  double side = 1;       ///< 1 for the contact's object a
  Vec3 normal;           ///< towards the body
  Vec3 velocity;         ///< now [m/s]
  Vec3 impulse, change;  ///< on the body, and what is to be added to it [N·s]
  double min_speed = 0, friction = 0;
  Hold hold = Hold::none;
};

bool is_immovable(const WorldState& world, ProxyId object) {
  const BodyId id = world.body_of(object);
  return !world.contact_world.moves(object) && !(id.valid() && world.bodies[id].sways());
}

std::vector<SettledNode> settled_nodes(const WorldState& world, const TouchedBody& touched,
                                       const ElasticResponse& response) {
  std::vector<SettledNode> nodes;
  std::set<int> rows;
  const std::span<const Contact> contacts = world.contact_world.contacts();
  for (std::size_t k = 0; k < touched.points.size(); ++k) {
    const NodeId id = touched.points[k].node;
    const Contact& contact = contacts[response.contacts[k]];
    const bool is_a = contact.a == response.object;
    if (!id.valid() || !world.nodes.constraints[id].is_free() || !is_immovable(world, is_a ? contact.b : contact.a))
      continue;
    if (!rows.insert(world.nodes.rows[id]).second) continue;  // two things hold it: the first one is settled
    SettledNode& node = nodes.emplace_back();
    node.contact = response.contacts[k];
    node.row = world.nodes.rows[id];
    node.side = is_a ? 1 : -1;
    node.normal = node.side * contact.normal;
    node.velocity = response.velocities.col(static_cast<Eigen::Index>(k));
    node.impulse = response.impulses.col(static_cast<Eigen::Index>(k));
    node.change.setZero();
    const ContactWorld::Law law = world.contact_world.law(node.contact);
    node.min_speed = law.target_velocity;
    node.friction = law.friction;
    if (node.impulse.dot(node.normal) > 0 || node.normal.dot(node.velocity) < node.min_speed)
      node.hold = node.friction > 0 ? Hold::sticks : Hold::slides;
  }
  return nodes;
}

FixedRow fixed_row(const SettledNode& node) {
  const Mat3 across = Mat3::Identity() - node.normal * node.normal.transpose();
  const Vec3 known = (node.min_speed - node.normal.dot(node.velocity)) * node.normal;
  if (node.hold == Hold::slides) return {node.row, across, known};
  return {node.row, Mat3::Zero(), known - across * node.velocity};
}

/// What a node that is not wholly held gets beside what holds it.
Vec3 given_impulse(const SettledNode& node) {
  if (node.hold == Hold::none) return -node.impulse;
  return node.hold == Hold::slides ? node.change : Vec3(Vec3::Zero());
}

/// Whether the node's hold is right under the `velocity` that it has now; else corrects it.
bool correct_hold(SettledNode& node, const Vec3& velocity, double negligible) {
  const Vec3 total = node.impulse + node.change;
  const double pushing = node.normal.dot(total), speed = node.normal.dot(velocity);
  if (node.hold == Hold::none) {
    if (speed >= node.min_speed - negligible) return true;
    node.hold = node.friction > 0 ? Hold::sticks : Hold::slides;
    return false;
  }
  if (pushing < 0) {
    node.hold = Hold::none;
    return false;
  }
  const Vec3 friction = total - pushing * node.normal, sliding = velocity - speed * node.normal;
  const double limit = node.friction * pushing;
  if (node.hold == Hold::sticks) {
    if (friction.norm() <= limit * (1 + 1e-6)) return true;
    node.hold = Hold::slides;
    return false;
  }
  if (node.friction == 0) return true;
  if (friction.dot(sliding) > negligible * friction.norm()) {
    node.hold = Hold::sticks;
    return false;
  }
  return std::abs(friction.norm() - limit) <= 0.01 * limit;
}

/// The friction of a node that slides, at its limit.
void limit_friction(SettledNode& node) {
  const Vec3 total = node.impulse + node.change;
  const double pushing = std::max(0.0, node.normal.dot(total)), limit = node.friction * pushing;
  const Vec3 friction = total - node.normal.dot(total) * node.normal;
  const double size = friction.norm();
  const Vec3 wanted = size > 0 ? Vec3(limit / size * friction) : Vec3(Vec3::Zero());
  node.change = wanted + node.normal.dot(total) * node.normal - node.impulse;
}

/// The node's impulse, within what contact and friction can do.
Vec3 admissible(const SettledNode& node) {
  const Vec3 total = node.impulse + node.change;
  const double pushing = std::max(0.0, node.normal.dot(total)), limit = node.friction * pushing;
  Vec3 friction = total - node.normal.dot(total) * node.normal;
  if (friction.norm() > limit) friction *= limit / friction.norm();
  return pushing * node.normal + friction;
}

/// Solves for the changes of impulse until every node is held as it should be.
void settle(WorldState& world, TouchedBody& touched, const ElasticResponse& response, double dt,
            std::vector<SettledNode>& nodes) {
  constexpr int kMaxChanges = 10;
  Body& body = world.bodies[touched.body];
  const ImplicitStep step = implicit_step(world, body, dt);
  const double scale = response.impulses.norm(), negligible = 1e-6 * dt * world.model->scene.gravity.norm();
  NodeVectors change;
  for (int round = 0; round < kMaxChanges; ++round) {
    std::vector<FixedRow> held;
    NodeVectors impulses = NodeVectors::Zero(3, body.system->rows());
    for (SettledNode& node : nodes) {
      if (node.hold == Hold::slides) limit_friction(node);
      impulses.col(node.row) += given_impulse(node);
      if (node.hold != Hold::none) held.push_back(fixed_row(node));
    }
    body.system->hold(held, world.nodes.positions, step.relative_residual * scale, step.max_iterations, impulses,
                      change);
    bool right = true;
    for (SettledNode& node : nodes) {
      node.change = impulses.col(node.row);
      right &= correct_hold(node, node.velocity + change.col(node.row), negligible);
    }
    if (right) break;
  }
  touched.change += change;
}

}  // namespace

bool settle_contacts(WorldState& world, TouchedBodies& touched, double dt) {
  std::vector<std::vector<SettledNode>> nodes(touched.bodies.size());
  parallel_for(static_cast<int>(touched.bodies.size()), 1, [&](int begin, int end) {
    for (int i = begin; i < end; ++i) {
      if (touched.bodies[i].change.size() == 0) continue;
      nodes[i] = settled_nodes(world, touched.bodies[i], touched.responses[i]);
      if (!nodes[i].empty()) settle(world, touched.bodies[i], touched.responses[i], dt, nodes[i]);
    }
  });
  bool any = false;
  for (const std::vector<SettledNode>& of_body : nodes)
    for (const SettledNode& node : of_body) {
      world.contact_world.contacts()[node.contact].impulse = node.side * admissible(node);
      any = true;
    }
  return any;
}

}  // namespace griffith
