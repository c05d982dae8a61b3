#include "sim/world/phases/touched_body.h"

#include <Eigen/LU>
#include <algorithm>

#include "sim/core/parallel.h"
#include "sim/core/rotation.h"
#include "sim/world/bodies/bodies.h"
#include "sim/world/world_state.h"

namespace griffith {
namespace {

Vec3 surface_position(const WorldState& world, const SurfacePoint& point) {
  Vec3 position = Vec3::Zero();
  for (int i = 0; i < 3; ++i) position += point.weights[i] * world.nodes.positions[point.nodes[i]];
  return position;
}

/// The index of one of a body's nodes.
int place_of(const Body& body, NodeId node) {
  return static_cast<int>(std::lower_bound(body.nodes.begin(), body.nodes.end(), node) - body.nodes.begin());
}

/// Where the proxy, which does not deform, has this point of the surface.
Vec3 proxy_position(const Body& body, const SurfacePoint& point) {
  Vec3 arm = Vec3::Zero();
  for (int i = 0; i < 3; ++i) arm += point.weights[i] * body.reference_arms.col(place_of(body, point.nodes[i]));
  return body.motion.center + body.orientation * arm;
}

/// The touched surface points by the nodes that carry them, `row_of` each.
template <class RowOf>
std::vector<WeightedRows> weighted_rows(const WorldState& world, std::span<const TouchedPoint> points, RowOf row_of) {
  std::vector<WeightedRows> rows(points.size());
  for (std::size_t i = 0; i < points.size(); ++i)
    for (int k = 0; k < 3; ++k) {
      const NodeId node = points[i].surface.nodes[k];
      rows[i].rows[k] = row_of(node);
      rows[i].weights[k] = points[i].surface.weights[k] * world.nodes.constraints[node].allowed;
    }
  return rows;
}

/// Cross matrices of the arms from the body's centre of mass to `place` of each point.
std::vector<Mat3> arm_matrices(const Body& body, std::span<const TouchedPoint> points, Vec3 TouchedPoint::*place) {
  std::vector<Mat3> arms;
  for (const TouchedPoint& point : points) arms.push_back(cross_matrix(point.*place - body.motion.center));
  return arms;
}

/// Explicit integration moves single nodes before their neighbours answer. What the offsets of the contacts from the
/// surface add is the rigid answer at the contacts less that at the surface, which the nodes' hold.
PointCompliance explicit_compliance(const WorldState& world, const Body& body, std::span<const TouchedPoint> points) {
  std::vector<Mat3> nodes;
  for (NodeId node : body.nodes) nodes.push_back(Mat3::Identity() / world.nodes.masses[node]);
  PointCompliance compliance =
      node_compliance(weighted_rows(world, points, [&](NodeId node) { return place_of(body, node); }), nodes);
  if (body.supported()) return compliance;
  const Mat3 inverse_inertia = body.motion.inertia.inverse();
  compliance.add_modes(inverse_inertia, arm_matrices(body, points, &TouchedPoint::contact), false);
  compliance.add_modes(inverse_inertia, arm_matrices(body, points, &TouchedPoint::position), true);
  return compliance;
}

/// That of the implicit step's system: about what deforms, and of a free body, exactly, how the whole of it moves. A
/// sum of what is positive semidefinite each: with less, impulses would feed each other.
PointCompliance implicit_compliance(const WorldState& world, const Body& body, std::span<const TouchedPoint> points,
                                    double dt) {
  const auto rows = weighted_rows(world, points, [&](NodeId node) { return world.nodes.rows[node]; });
  if (body.supported()) return body.system->compliance(rows);
  PointCompliance compliance = body.system->deforming_compliance(rows, world.nodes.positions, world.nodes.masses);
  const double damping = 1 + dt * world.material_of(body).mass_damping;
  const std::vector<Mat3> whole(points.size(), Mat3::Identity());
  compliance.add_modes(Mat3::Identity() / (damping * body.motion.mass), whole, false);
  compliance.add_modes(body.motion.inertia.inverse() / damping, arm_matrices(body, points, &TouchedPoint::contact),
                       false);
  return compliance;
}

bool is_elastic(const WorldState& world, ProxyId object) {
  const BodyId id = world.body_of(object);
  return id.valid() && !world.bodies[id].rigid && !world.bodies[id].asleep;
}

/// How fast the sides of each contact come together as if it did not push [m/s].
std::vector<double> approach_speeds(const WorldState& world, const TouchedBodies& touched) {
  const std::span<const Contact> contacts = world.contact_world.contacts();
  std::vector<double> speeds(contacts.size(), 0.0);
  for (std::size_t i = 0; i < contacts.size(); ++i)
    for (const auto& [object, side] : {std::pair(contacts[i].a, 1.0), std::pair(contacts[i].b, -1.0)}) {
      if (is_elastic(world, object)) continue;
      const RigidState state = world.contact_world.state(object);
      const Vec3 arm = contacts[i].position - state.pose.translation;
      speeds[i] -= side * contacts[i].normal.dot(state.velocity + state.angular_velocity.cross(arm));
    }
  for (std::size_t i = 0; i < touched.bodies.size(); ++i) {
    const Eigen::Matrix3Xd velocities = point_velocities(world, touched.bodies[i]);
    for (Eigen::Index k = 0; k < velocities.cols(); ++k) {
      const int index = touched.responses[i].contacts[k];
      const double side = contacts[index].a == touched.responses[i].object ? 1 : -1;
      speeds[index] -= side * contacts[index].normal.dot(velocities.col(k));
    }
  }
  return speeds;
}

void list_contacts(const WorldState& world, TouchedBodies& touched) {
  std::vector<int> index_of_body(world.bodies.size(), -1);
  const std::span<const Contact> contacts = world.contact_world.contacts();
  for (std::size_t i = 0; i < contacts.size(); ++i)
    for (bool is_a : {true, false}) {
      const ProxyId object = is_a ? contacts[i].a : contacts[i].b;
      if (!is_elastic(world, object)) continue;
      const BodyId id = world.body_of(object);
      if (index_of_body[id] < 0) {
        index_of_body[id] = static_cast<int>(touched.bodies.size());
        touched.bodies.emplace_back().body = id;
        touched.responses.emplace_back().object = object;
      }
      TouchedPoint& point = touched.bodies[index_of_body[id]].points.emplace_back();
      point.contact = contacts[i].position;
      point.node = is_a ? contacts[i].node_a : contacts[i].node_b;
      touched.responses[index_of_body[id]].contacts.push_back(static_cast<int>(i));
    }
}

}  // namespace

TouchedBodies touched_bodies(const WorldState& world) {
  TouchedBodies touched;
  list_contacts(world, touched);
  parallel_for(static_cast<int>(touched.bodies.size()), 1, [&](int begin, int end) {
    for (int i = begin; i < end; ++i) {
      const SurfaceSearch surface(world, world.bodies[touched.bodies[i].body]);
      for (TouchedPoint& point : touched.bodies[i].points) {
        point.surface = point.node.valid() ? SurfacePoint{{point.node, point.node, point.node}, Vec3::UnitX()}
                                           : surface.closest(point.contact);
        point.position = surface_position(world, point.surface);
      }
    }
  });
  return touched;
}

void correct_distances(WorldState& world, const TouchedBodies& touched) {
  const std::span<Contact> contacts = world.contact_world.contacts();
  for (std::size_t i = 0; i < touched.bodies.size(); ++i) {
    const Body& body = world.bodies[touched.bodies[i].body];
    for (std::size_t k = 0; k < touched.bodies[i].points.size(); ++k) {
      const TouchedPoint& point = touched.bodies[i].points[k];
      Contact& contact = contacts[touched.responses[i].contacts[k]];
      if (contact.node_a.valid() || contact.node_b.valid()) continue;
      const double side = contact.a == body.proxy ? 1 : -1;
      contact.distance += side * contact.normal.dot(point.position - proxy_position(body, point.surface));
    }
  }
}

void drop_near_misses(WorldState& world, TouchedBodies& touched, double dt) {
  const std::vector<int> index = world.contact_world.drop_near_misses(dt, approach_speeds(world, touched));
  for (std::size_t i = 0; i < touched.bodies.size(); ++i) {
    std::vector<TouchedPoint> points;
    std::vector<int> contacts;
    for (std::size_t k = 0; k < touched.bodies[i].points.size(); ++k) {
      const int kept = index[touched.responses[i].contacts[k]];
      if (kept < 0) continue;
      points.push_back(touched.bodies[i].points[k]);
      contacts.push_back(kept);
    }
    touched.bodies[i].points = std::move(points);
    touched.responses[i].contacts = std::move(contacts);
  }
}

void prepare_response(const WorldState& world, const TouchedBody& touched, double dt, ElasticResponse& response) {
  response.free_velocities = response.velocities = point_velocities(world, touched);
  response.impulses = Eigen::Matrix3Xd::Zero(3, static_cast<Eigen::Index>(touched.points.size()));
  const Body& body = world.bodies[touched.body];
  if (world.integrates_explicitly()) {
    response.compliance = explicit_compliance(world, body, touched.points);
  } else {
    response.compliance = implicit_compliance(world, body, touched.points, dt);
    response.compliance.scale(body.compliance_factor);
  }
}

Eigen::Matrix3Xd point_velocities(const WorldState& world, const TouchedBody& touched) {
  const Body& body = world.bodies[touched.body];
  const Vec3 spin = body.supported() ? Vec3(Vec3::Zero()) : motion_of(world, body).angular_velocity;
  Eigen::Matrix3Xd velocities(3, touched.points.size());
  for (std::size_t k = 0; k < touched.points.size(); ++k) {
    const TouchedPoint& point = touched.points[k];
    velocities.col(k) = spin.cross(point.contact - point.position);
    for (int i = 0; i < 3; ++i)
      velocities.col(k) += point.surface.weights[i] * world.nodes.velocities[point.surface.nodes[i]];
  }
  return velocities;
}

void add_nodal_impulses(const WorldState& world, const TouchedBody& touched, const Eigen::Matrix3Xd& impulses,
                        std::vector<Vec3>& nodal) {
  const Body& body = world.bodies[touched.body];
  Vec3 torque = Vec3::Zero();
  for (std::size_t k = 0; k < touched.points.size(); ++k) {
    const TouchedPoint& point = touched.points[k];
    for (int i = 0; i < 3; ++i) nodal[point.surface.nodes[i]] += point.surface.weights[i] * impulses.col(k);
    torque += (point.contact - point.position).cross(impulses.col(k));
  }
  if (body.supported()) return;
  const Vec3 spin = body.motion.inertia.inverse() * torque;
  for (NodeId node : body.nodes)
    nodal[node] += world.nodes.masses[node] * spin.cross(world.nodes.positions[node] - body.motion.center);
}

}  // namespace griffith
