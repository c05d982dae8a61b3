#include <algorithm>
#include <cmath>
#include <ranges>

#include "sim/contact/bullet/contact_world.h"
#include "sim/geometry/disjoint_sets.h"

namespace griffith {

using namespace contact;

namespace {

/// Overlap that remains, as a fraction of the smaller radius, so that objects at rest stay in contact.
constexpr double kOverlapAtRest = 1.2e-3;
/// Mobility of a hinge as a fraction of that of the free body: without any, contacts that press on it would find no
/// compliance.
constexpr double kHingedMobility = 1e-3;

}  // namespace

Mat3 contact::world_inertia(const Object& object) {
  const Mat3 rotation = object.state.pose.rotation.toRotationMatrix();
  return rotation * object.inverse_inertia.inverse() * rotation.transpose();
}

Mat3 contact::inverse_world_inertia(const Object& object) {
  return object.place.rotation * object.inverse_inertia * object.place.rotation.transpose();
}

namespace {

/// Returns the smaller size of two objects, of which the ground has none [m].
double smaller(double Shape::*size, const Object& a, const Object& b) {
  if (a.kind == Kind::ground) return b.shape.*size;
  return b.kind == Kind::ground ? a.shape.*size : std::min(a.shape.*size, b.shape.*size);
}

}  // namespace

double contact::smaller_radius(const Object& a, const Object& b) { return smaller(&Shape::radius, a, b); }

double contact::smaller_thickness(const Object& a, const Object& b) { return smaller(&Shape::thickness, a, b); }

/// Divides the contacts into those of groups of rigid objects and all others.
void ContactWorld::Impl::split_groups() {
  DisjointSets sets(static_cast<int>(objects.size()));
  for (const Contact& contact : contacts)
    if (objects[contact.a].yields() && objects[contact.b].yields())
      sets.join(static_cast<int>(contact.a.index()), static_cast<int>(contact.b.index()));
  constexpr int kNew = -1, kElastic = -2;
  std::vector<int> group_of(objects.size(), kNew);  // of the sets' roots
  for (std::size_t i = 0; i < objects.size(); ++i)
    if (objects[i].elastic) group_of[sets.find(static_cast<int>(i))] = kElastic;
  rigid_groups.clear();
  elastic_contacts.clear();
  moves_rigidly.assign(objects.size(), false);
  for (std::size_t i = 0; i < contacts.size(); ++i) {
    const ProxyId yielding = objects[contacts[i].a].yields() ? contacts[i].a : contacts[i].b;
    int& group = group_of[sets.find(static_cast<int>(yielding.index()))];
    if (group == kElastic || !objects[yielding].yields()) {
      elastic_contacts.push_back(static_cast<int>(i));
      continue;
    }
    if (group == kNew) {
      group = static_cast<int>(rigid_groups.size());
      rigid_groups.emplace_back();
    }
    rigid_groups[group].contacts.push_back(static_cast<int>(i));
    for (const ProxyId side : {contacts[i].a, contacts[i].b}) {
      if (!objects[side].yields() || moves_rigidly[side]) continue;
      moves_rigidly[side] = true;
      rigid_groups[group].bodies.push_back(static_cast<int>(side.index()));
    }
  }
}

/// Returns the initial state of a step of `dt` [s], with the effect of external forces in it.
RigidBody ContactWorld::Impl::rigid_body(const Object& object, double dt) const {
  RigidBody body;
  body.velocity = object.state.velocity;
  body.spin = object.state.angular_velocity;
  body.moves = object.moves() || object.hinge >= 0;
  if (object.hinge >= 0) {
    const HingedObject& hinge = hinged[object.hinge];
    body.is_hinged = true;
    body.inverse_mass = kHingedMobility / hinge.mass;
    body.velocity.setZero();
    body.spin = hinge.first_spin;
    body.inverse_inertia = hinge.inverse_inertia;
    body.turning = (hinge.spin - hinge.first_spin) / dt;
  }
  if (!object.moves()) return body;
  body.inverse_mass = object.inverse_mass;
  body.is_round = object.is_sphere();
  body.inverse_inertia = inverse_world_inertia(object);
  body.acceleration = (object.state.velocity - object.first_velocity) / dt;
  body.turning = (object.state.angular_velocity - object.first_spin) / dt;
  if (object.kind == Kind::projectile) body.acceleration += gravity;
  body.velocity = object.first_velocity;
  body.spin = object.first_spin;
  return body;
}

/// Returns the point about which an object turns [m].
const Vec3& ContactWorld::Impl::center(const Object& object) const {
  return object.hinge >= 0 ? hinged[object.hinge].place : object.state.pose.translation;
}

/// Returns the mass of a hinged object about its place, across whose axes it hardly turns.
RigidMass ContactWorld::Impl::hinged_mass(const Object& object) const {
  const HingedObject& hinge = hinged[object.hinge];
  const Mat3 stiff = kHingedMobility * hinge.inverse_inertia.trace() * Mat3::Identity();
  return {hinge.mass / kHingedMobility, (hinge.inverse_inertia + stiff).inverse()};
}

RigidContact ContactWorld::Impl::rigid_contact(std::size_t index, double dt) const {
  const Contact& contact = contacts[index];
  const Object &a = objects[contact.a], &b = objects[contact.b];
  const RigidBody &body_a = scratch.rigid_bodies[contact.a], &body_b = scratch.rigid_bodies[contact.b];
  RigidContact row;
  row.a = static_cast<int>(contact.a.index());
  row.b = static_cast<int>(contact.b.index());
  row.normal = contact.normal;
  row.arm_a = contact.position - center(a);
  row.arm_b = contact.position - center(b);
  const double allowed = allowance(contact.a, contact.b);
  row.distance = distance_beyond(contact.distance, allowed);
  row.is_mean = contact.position_at == PositionTime::mean;
  row.resting = kOverlapAtRest * smaller_thickness(a, b);
  row.fallen = gravity.dot(contact.position);
  row.friction = std::sqrt(a.surface.friction * b.surface.friction);
  const auto speed = [&](const RigidBody& body, const Vec3& arm) {
    return row.normal.dot(body.velocity + body.spin.cross(arm));
  };
  row.fall = -dt * (row.normal.dot(body_a.acceleration + body_a.turning.cross(row.arm_a)) -
                    row.normal.dot(body_b.acceleration + body_b.turning.cross(row.arm_b)));
  row.approach = speed(body_b, row.arm_b) - speed(body_a, row.arm_a) + row.fall;
  const bool strikes = row.approach > touching_speed(a, b, dt) && row.approach * dt > contact.distance && allowed == 0;
  row.restitution = strikes ? std::min(a.surface.restitution, b.surface.restitution) : 0;
  row.force = remembered_force(memories[index]);
  return row;
}

int ContactWorld::Impl::solve_rigid_groups(double dt) {
  scratch.rigid_bodies.resize(objects.size());
  std::vector<RigidContact>& rows = scratch.rigid_contacts;
  std::vector<int>& contact_of = scratch.contact_of_row;
  rows.clear();
  contact_of.clear();
  for (const int i : std::views::iota(0, static_cast<int>(objects.size())))
    scratch.rigid_bodies[i] = rigid_body(objects[i], dt);
  for (RigidGroup& group : rigid_groups)
    for (int& index : group.contacts) {
      contact_of.push_back(index);
      rows.push_back(rigid_contact(index, dt));
      index = static_cast<int>(rows.size()) - 1;
    }
  const int work = solve_rigid(scratch.rigid_bodies, rows, rigid_groups, dt);
  for (std::size_t i = 0; i < rows.size(); ++i) {
    Contact& contact = contacts[contact_of[i]];
    contact.approach = rows[i].approach;
    contact.impulse = rows[i].impulse;
    contact.couple = rows[i].couple;
    remember_force(memories[contact_of[i]], rows[i].force);
  }
  return work;
}

/// Stores the displacement of the substeps beyond that of the final velocities. In each group the motion out of
/// overlaps lifts by no more energy than its contacts have taken: energy does not grow.
void ContactWorld::Impl::move_rigid_groups(double dt) {
  for (const RigidGroup& group : rigid_groups) {
    double lift = 0, dissipated = 0, count = 0;
    for (const int i : group.bodies) {
      const Object& object = objects[i];
      if (!object.moves()) continue;
      ++count;
      lift -= gravity.dot(scratch.rigid_bodies[i].push) / object.inverse_mass;
      dissipated += object.dissipated + kinetic_energy(object, object.first_velocity, object.first_spin) -
                    kinetic_energy(object, object.state.velocity, object.state.angular_velocity) +
                    gravity.dot(scratch.rigid_bodies[i].displacement) / object.inverse_mass;
    }
    const double fraction = lift > 0 ? std::clamp(dissipated / lift, 0.0, 1.0) : 1;
    const double left = (dissipated - fraction * lift) / count;
    for (const int i : group.bodies) {
      const RigidBody& body = scratch.rigid_bodies[i];
      Object& object = objects[i];
      if (!object.moves()) continue;
      object.dissipated = std::max(0.0, left);
      object.pushed_out = fraction * body.push;
      object.correction = {body.displacement + object.pushed_out - dt * object.state.velocity,
                           body.rotation + fraction * body.push_rotation - dt * object.state.angular_velocity};
    }
  }
}

}  // namespace griffith
