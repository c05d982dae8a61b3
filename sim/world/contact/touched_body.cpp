#include "sim/world/contact/touched_body.h"

#include <Eigen/LU>
#include <algorithm>
#include <limits>
#include <utility>

#include "sim/core/parallel.h"
#include "sim/core/rotation.h"
#include "sim/world/bodies/bodies.h"
#include "sim/world/bodies/effective_law.h"
#include "sim/world/bodies/supported_motion.h"
#include "sim/world/motion/turning.h"
#include "sim/world/state/world_state.h"

namespace griffith {
namespace {

/// Returns the index of one of a body's nodes.
int place_of(const Body& body, NodeId node) {
  return static_cast<int>(std::lower_bound(body.nodes.begin(), body.nodes.end(), node) - body.nodes.begin());
}

/// Returns the place of this point of the surface on the proxy, which does not deform.
Vec3 proxy_position(const Body& body, const SurfacePoint& point) {
  Vec3 arm = Vec3::Zero();
  for (int i = 0; i < 3; ++i) arm += point.weights[i] * body.reference_arms.col(place_of(body, point.nodes[i]));
  return body.motion.center + body.orientation * arm;
}

bool is_elastic(const WorldState& world, ProxyId object) {
  const BodyId id = world.body_of(object);
  return id.valid() && !world.bodies[id].rigid && !world.bodies[id].asleep;
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
        touched.objects.emplace_back().object = object;
      }
      TouchedPoint& point = touched.bodies[index_of_body[id]].points.emplace_back();
      point.contact = contacts[i].position;
      point.node = is_a ? contacts[i].node_a : contacts[i].node_b;
      touched.objects[index_of_body[id]].contacts.push_back(static_cast<int>(i));
    }
}

/// Adds the bonds of bodies, also of those that nothing touches.
void list_bonds(const WorldState& world, TouchedBodies& touched) {
  for (BondsOfBody& bonds : acting_bonds(world)) {
    auto of = std::ranges::find(touched.bodies, bonds.body, &TouchedBody::body);
    if (of == touched.bodies.end()) {
      touched.objects.emplace_back().object = world.bodies[bonds.body].proxy;
      touched.bodies.emplace_back().body = bonds.body;
      of = touched.bodies.end() - 1;
    }
    of->bond_impulses.assign(bonds.pairs.size(), Vec3::Zero());
    of->bonds = std::move(bonds);
  }
}

}  // namespace

bool acts_on_first(const WorldState& world, ProxyId first, ProxyId second) {
  const auto mass = [&](ProxyId object) {
    const std::optional<RigidMass> moved = world.contact_world.rigid_mass(object);
    if (moved) return moved->mass;
    const BodyId id = world.body_of(object);
    const bool is_free = id.valid() && !world.bodies[id].supported();
    return is_free ? world.bodies[id].motion.mass : std::numeric_limits<double>::infinity();
  };
  return mass(first) <= mass(second);
}

TouchedPoint touched_node(const WorldState& world, NodeId node, const Vec3& place) {
  return {{{node, node, node}, Vec3::UnitX()}, node, place, world.nodes.positions[node]};
}

TouchedPoint touched_point(const WorldState& world, const SurfaceSearch& surface, const Vec3& place) {
  const SurfacePoint point = surface.closest(place);
  return {point, NodeId(), place, point.interpolate(world.nodes.positions)};
}

TouchedBodies touched_bodies(const WorldState& world) {
  TouchedBodies touched;
  list_contacts(world, touched);
  list_bonds(world, touched);
  parallel_for(static_cast<int>(touched.bodies.size()), 1, [&](int begin, int end) {
    for (int i = begin; i < end; ++i) {
      const SurfaceSearch surface(world, world.bodies[touched.bodies[i].body]);
      for (TouchedPoint& point : touched.bodies[i].points)
        point = point.node.valid() ? touched_node(world, point.node, point.contact)
                                   : touched_point(world, surface, point.contact);
    }
  });
  return touched;
}

void place_contacts(const WorldState& world, TouchedBodies& touched, std::span<Contact> contacts) {
  for (std::size_t i = 0; i < touched.bodies.size(); ++i) {
    if (world.bodies[touched.bodies[i].body].quasi_static) continue;  // it touches as its proxy
    for (std::size_t k = 0; k < touched.bodies[i].points.size(); ++k) {
      Contact& contact = contacts[touched.objects[i].contacts[k]];
      if (contact.position_at == PositionTime::mean || is_of_nodes(contact)) continue;
      const bool is_a = contact.a == touched.objects[i].object, acts_on_a = acts_on_first(world, contact.a, contact.b);
      const double across = is_a == acts_on_a ? 0 : (is_a ? -1 : 1) * contact.distance;
      contact.position = touched.bodies[i].points[k].position + across * contact.normal;
    }
  }
  for (std::size_t i = 0; i < touched.bodies.size(); ++i)
    for (std::size_t k = 0; k < touched.bodies[i].points.size(); ++k)
      touched.bodies[i].points[k].contact = contacts[touched.objects[i].contacts[k]].position;
}

void fit_contacts(const WorldState& world, TouchedBodies& touched, std::span<Contact> contacts) {
  for (std::size_t i = 0; i < touched.bodies.size(); ++i) {
    const Body& body = world.bodies[touched.bodies[i].body];
    if (body.quasi_static) continue;
    for (std::size_t k = 0; k < touched.bodies[i].points.size(); ++k) {
      const TouchedPoint& point = touched.bodies[i].points[k];
      Contact& contact = contacts[touched.objects[i].contacts[k]];
      if (is_of_nodes(contact)) continue;
      const double side = contact.a == body.proxy ? 1 : -1;
      contact.distance += side * contact.normal.dot(point.position - proxy_position(body, point.surface));
    }
  }
  place_contacts(world, touched, contacts);
}

double foresee_turn(const WorldState& world, TouchedBody& touched, double dt) {
  const Body& body = world.bodies[touched.body];
  if (world.integrates_explicitly() || body.supported() || body.quasi_static || !deforms_visibly(world, body)) return 0;
  const RigidMotion whole = motion_of(world, body);
  const Mat3 turn = free_turn(whole.inertia, whole.angular_velocity, dt);
  double change = 0;
  for (TouchedPoint& point : touched.points) {
    const Vec3 velocity = point.surface.interpolate(world.nodes.velocities);
    const Vec3 arm = point.position - whole.center, deforming = velocity - whole.velocity_at(point.position);
    const Vec3 turned = turn * (arm + dt * deforming) - arm - dt * (velocity - whole.velocity);
    change = std::max(change, (turned - point.turned).norm());
    point.turned = turned;
  }
  return change;
}

namespace {

/// True if a node of a soft body may be pulled onto the ground by others, whatever its own speed.
bool strains_onto(const WorldState& world, const Contact& contact) {
  const bool is_ground_b = world.contact_world.is_ground(contact.b);
  if ((is_ground_b ? contact.node_a : contact.node_b) == NodeId()) return false;
  if (!is_ground_b && !world.contact_world.is_ground(contact.a)) return false;
  const Body& body = world.bodies[world.body_of(is_ground_b ? contact.a : contact.b)];
  return can_be_compacted(world, body) && deforms_visibly(world, body);
}

}  // namespace

std::vector<double> approach_speeds(const WorldState& world, const TouchedBodies& touched, double dt) {
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
      const int index = touched.objects[i].contacts[k];
      const double side = contacts[index].a == touched.objects[i].object ? 1 : -1;
      const Vec3& turned = touched.bodies[i].points[k].turned;
      speeds[index] -= side * contacts[index].normal.dot(velocities.col(k));
      if (!turned.isZero(0)) speeds[index] -= side * contacts[index].normal.dot(turned) / dt;
      if (strains_onto(world, contacts[index])) speeds[index] = std::max(speeds[index], contacts[index].distance / dt);
    }
  }
  return speeds;
}

void keep_contacts(TouchedBodies& touched, std::span<const int> index) {
  for (std::size_t i = 0; i < touched.bodies.size(); ++i) {
    std::vector<TouchedPoint> points;
    std::vector<int> contacts;
    for (std::size_t k = 0; k < touched.bodies[i].points.size(); ++k) {
      const int kept = index[touched.objects[i].contacts[k]];
      if (kept < 0) continue;
      points.push_back(touched.bodies[i].points[k]);
      contacts.push_back(kept);
    }
    touched.bodies[i].points = std::move(points);
    touched.objects[i].contacts = std::move(contacts);
  }
}

namespace {

/// Rotation of a body as a whole that impulses off its surface change.
struct WholeRotation {
  Vec3 center = Vec3::Zero();           ///< center of mass or pivot [m]
  Mat3 inverse_inertia = Mat3::Zero();  ///< about it; 0 across the axes of a pivot [1/(kg·m²)]
  Vec3 spin = Vec3::Zero();             ///< [rad/s]
};

/// Returns the rotation of a free body or of a quasi-static one that turns about a pivot. Others have none: contacts of
/// deforming bodies at supports lie on their surface.
WholeRotation rotation_of(const WorldState& world, const Body& body) {
  if (!body.supported())
    return {body.motion.center, body.motion.inertia.inverse(), motion_of(world, body).angular_velocity};
  const std::optional<Pivot> pivot = body.quasi_static ? pivot_of(world, body) : std::nullopt;
  if (!pivot) return {};
  const Turning turning = turning_of(world, body, *pivot);
  return {pivot->place, inverse_inertia_about(*pivot, turning.inertia), turning.spin};
}

}  // namespace

Eigen::Matrix3Xd point_velocities(const WorldState& world, const TouchedBody& touched) {
  const Vec3 spin = rotation_of(world, world.bodies[touched.body]).spin;
  Eigen::Matrix3Xd velocities(3, static_cast<Eigen::Index>(touched.points.size()));
  for (std::size_t k = 0; k < touched.points.size(); ++k) {
    const TouchedPoint& point = touched.points[k];
    velocities.col(k) = spin.cross(point.contact - point.position);
    for (int i = 0; i < 3; ++i)
      velocities.col(k) += point.surface.weights[i] * world.nodes.velocities[point.surface.nodes[i]];
  }
  return velocities;
}

WeightedRows weighted_rows(const WorldState& world, const SurfacePoint& point) {
  WeightedRows rows;
  for (int k = 0; k < 3; ++k) {
    rows.rows[k] = world.nodes.rows[point.nodes[k]];
    rows.weights[k] = point.weights[k] * world.nodes.constraints[point.nodes[k]].allowed;
  }
  return rows;
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
  const WholeRotation whole = rotation_of(world, body);
  const Vec3 spin = whole.inverse_inertia * torque;
  if (spin.isZero(0)) return;
  for (NodeId node : body.nodes)
    nodal[node] += world.nodes.masses[node] * spin.cross(world.nodes.positions[node] - whole.center);
}

}  // namespace griffith
