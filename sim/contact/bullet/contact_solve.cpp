#include <Eigen/LU>
#include <algorithm>
#include <cassert>
#include <cmath>

#include "sim/contact/bullet/contact_world.h"
#include "sim/core/parallel.h"
#include "sim/geometry/connected_groups.h"

namespace griffith {

using namespace contact;

namespace {

/// The share of an overlap that goes in a substep, and the overlap, as a share of the smaller radius, that stays, so
/// that all contacts of what rests go on touching.
constexpr double kCorrectionFraction = 0.1, kRestingFraction = 3e-4;
/// Of what goes, the next substeps take what this one leaves.
constexpr SolverLimits kRoughly{.work = 6'000, .min_sweeps = 8, .max_sweeps = 50, .tolerance = 1e-3};

Mat3 contact_axes(const Vec3& normal) {
  Mat3 axes;
  axes.col(0) = normal;
  axes.col(1) = normal.unitOrthogonal();
  axes.col(2) = normal.cross(axes.col(1));
  return axes;
}

/// The solver body of a rigid object.
SolverBody rigid_solver_body(const Object& object) {
  SolverBody solver_body;
  if (object.asleep) return solver_body;
  solver_body.inverse_mass = object.inverse_mass;
  const Mat3 rotation = object.state.pose.rotation.toRotationMatrix();
  solver_body.inverse_inertia = rotation * object.inverse_inertia * rotation.transpose();
  return solver_body;
}

double smaller_radius(const Object& a, const Object& b) {
  if (a.kind == Kind::ground) return b.shape.radius;
  return b.kind == Kind::ground ? a.shape.radius : std::min(a.shape.radius, b.shape.radius);
}

/// Kinetic energy of a free object, if it moved so as it lies [J].
double kinetic_energy(const Object& object, const Vec3& velocity, const Vec3& spin) {
  const Vec3 own_spin = object.state.pose.rotation.conjugate() * spin;
  return 0.5 *
         (velocity.squaredNorm() / object.inverse_mass + own_spin.dot(object.inverse_inertia.inverse() * own_spin));
}

Vec3 rigid_velocity(const SolverBody& solver_body, const ContactEnd& end) {
  return solver_body.velocity + solver_body.angular_velocity.cross(end.arm);
}

}  // namespace

double contact::distance_beyond(double distance, double allowed_overlap) {
  return distance < 0 ? std::min(0.0, distance + allowed_overlap) : distance;
}

std::vector<SolverBody> ContactWorld::Impl::rigid_solver_bodies(double dt) const {
  std::vector<SolverBody> made;
  made.reserve(objects.size());
  for (const Object& object : objects) {
    made.push_back(rigid_solver_body(object));
    made.back().velocity = object.state.velocity;
    made.back().angular_velocity = object.state.angular_velocity;
    if (object.kind == Kind::projectile && object.moves()) made.back().velocity += dt * gravity;
  }
  return made;
}

std::vector<ContactConstraint> ContactWorld::Impl::constraints(double dt) const {
  std::vector<ContactConstraint> made(contacts.size());
  for (std::size_t i = 0; i < made.size(); ++i) {
    const Contact& contact = contacts[i];
    const Object &a = objects[contact.a], &b = objects[contact.b];
    ContactConstraint& row = made[i];
    row.a = {static_cast<int>(contact.a.index()), -1, contact.position - a.state.pose.translation};
    row.b = {static_cast<int>(contact.b.index()), -1, contact.position - b.state.pose.translation};
    row.axes = contact_axes(contact.normal);
    row.friction = std::sqrt(a.surface.friction * b.surface.friction);
    // The last impulse, as a mean force along the axes: they hardly turn.
    row.impulse = dt * remembered_force(memories[i]);
    if (row.friction == 0) row.impulse.tail<2>().setZero();
  }
  return made;
}

/// A slower approach does not strike: that of what falls from rest within a substep, and of a fall through a small
/// share of the smaller object's size [m/s].
double ContactWorld::Impl::touching_speed(const Object& a, const Object& b, double dt) const {
  constexpr double kSettledFraction = 0.06;
  return std::max(2 * dt * gravity.norm(), kSettledFraction * std::sqrt(gravity.norm() * smaller_radius(a, b)));
}

/// A gap that closes in this substep is struck now, at full speed, rather than half now and half in the next one.
bool ContactWorld::Impl::strikes(const Contact& contact, double dt) const {
  return contact.approach > touching_speed(objects[contact.a], objects[contact.b], dt) &&
         contact.approach * dt > contact.distance;
}

/// The speed of parting with which what was struck, now instead of when the gap will have closed, comes back to e² of
/// the height that it fell from. Stepped as here, a fall with g keeps v²/2 + g y + g dt v/2, v downwards.
double ContactWorld::Impl::rebound_speed(const Contact& contact, double dt) const {
  const Object &a = objects[contact.a], &b = objects[contact.b];
  const double restitution = std::min(a.surface.restitution, b.surface.restitution);
  const Vec3 relative_gravity = (a.is_free() - b.is_free()) * gravity;
  const double gain = -dt * contact.normal.dot(relative_gravity);  // of the approach, in this substep
  const double before = contact.approach - gain, climb = 2 * gain / dt * std::max(0.0, contact.distance);
  // The top of the steps lies up to g dt²/8 above that of the fall.
  const double over = gain * gain / 4;
  const double left = restitution * restitution * (before * before + gain * before + climb) - climb - over;
  return left > 0 ? -gain / 2 + std::sqrt(gain * gain / 4 + left) : 0;
}

double ContactWorld::Impl::target_velocity(const Contact& contact, double dt) const {
  if (!strikes(contact, dt)) return -std::max(0.0, contact.distance) / dt;
  const Object &a = objects[contact.a], &b = objects[contact.b];
  if (a.elastic || b.elastic || allowance(contact.a, contact.b) > 0) return 0;
  return rebound_speed(contact, dt);
}

int ContactWorld::Impl::solve(double dt, std::span<const ElasticObject> elastic) {
  assert(dt > 0);
  std::vector<SolverBody> solver_bodies = rigid_solver_bodies(dt);
  solved = constraints(dt);
  for (Object& object : objects) object.elastic = false;
  std::vector<const ElasticObject*> elastic_of(objects.size(), nullptr);
  for (const ElasticObject& object : elastic) {
    objects[object.object].elastic = true;
    elastic_of[object.object] = &object;
    for (std::size_t point = 0; point < object.contacts.size(); ++point) {
      ContactConstraint& row = solved[object.contacts[point]];
      (row.a.solver_body == object.object.index() ? row.a : row.b).point = static_cast<int>(point);
    }
  }
  const auto free_velocity = [&](const ContactEnd& end) {
    if (const ElasticObject* object = elastic_of[end.solver_body]) return Vec3(object->free_velocities.col(end.point));
    return rigid_velocity(solver_bodies[end.solver_body], end);
  };
  free_velocities.resize(contacts.size());
  for (std::size_t i = 0; i < contacts.size(); ++i) {
    free_velocities[i] = free_velocity(solved[i].a) - free_velocity(solved[i].b);
    contacts[i].approach = -contacts[i].normal.dot(free_velocities[i]);
    solved[i].target_velocity = target_velocity(contacts[i], dt);
  }
  const int relaxations = solve_rigid_groups(solver_bodies);
  for (std::size_t i = 0; i < contacts.size(); ++i) contacts[i].impulse = solved[i].axes * solved[i].impulse;
  return relaxations;
}

int ContactWorld::Impl::solve_rigid_groups(std::vector<SolverBody>& solver_bodies) {
  const std::vector<int> groups = connected_groups(static_cast<int>(objects.size()), touching_pairs());
  const std::vector<bool> is_elastic = are_in_elastic_groups(groups);
  std::vector<ContactConstraint> rows;
  std::vector<std::size_t> indices;
  for (std::size_t i = 0; i < contacts.size(); ++i)
    if (!is_elastic[contacts[i].a] && !is_elastic[contacts[i].b]) {
      rows.push_back(solved[i]);
      indices.push_back(i);
    }
  const int relaxations = solve_impulses(rows, solver_bodies);
  for (std::size_t i = 0; i < rows.size(); ++i) solved[indices[i]] = rows[i];
  return relaxations;
}

/// True for objects of groups with one that is elastic; false for what no impulse moves.
std::vector<bool> ContactWorld::Impl::are_in_elastic_groups(const std::vector<int>& groups) const {
  std::vector<bool> of_group(objects.size(), false), of_object(objects.size(), false);
  for (std::size_t i = 0; i < objects.size(); ++i)
    if (objects[i].elastic) of_group[groups[i]] = true;
  for (std::size_t i = 0; i < objects.size(); ++i) of_object[i] = objects[i].responds() && of_group[groups[i]];
  return of_object;
}

std::vector<std::vector<int>> ContactWorld::Impl::elastic_groups() const {
  const std::vector<int> groups = connected_groups(static_cast<int>(objects.size()), touching_pairs());
  const std::vector<bool> is_elastic = are_in_elastic_groups(groups);
  std::vector<int> index_of(objects.size(), -1);
  std::vector<std::vector<int>> found;
  for (std::size_t i = 0; i < contacts.size(); ++i) {
    const ProxyId object = is_elastic[contacts[i].a] ? contacts[i].a : contacts[i].b;
    if (!is_elastic[object]) continue;
    int& index = index_of[groups[object]];
    if (index < 0) {
      index = static_cast<int>(found.size());
      found.emplace_back();
    }
    found[index].push_back(static_cast<int>(i));
  }
  return found;
}

/// Those whose impulses pass on to others.
std::vector<std::pair<int, int>> ContactWorld::Impl::touching_pairs() const {
  std::vector<std::pair<int, int>> touching;
  for (const Contact& contact : contacts)
    if (objects[contact.a].responds() && objects[contact.b].responds())
      touching.emplace_back(contact.a.index(), contact.b.index());
  return touching;
}

void ContactWorld::Impl::remember_impulses(double dt) {
  for (std::size_t i = 0; i < contacts.size(); ++i) {
    const Vec3 force = solved[i].axes.transpose() * contacts[i].impulse / dt;
    remember_force(memories[i], {std::max(0.0, force[0]), force[1], force[2]});
  }
}

void ContactWorld::Impl::advance(double dt) {
  remember_impulses(dt);
  read_back_impulses(dt);
  resist_rolling();
  quieten(dt);
  correct_positions(solved, dt);
  move_projectiles(dt);
}

std::vector<ContactWorld::Impl::Momentum> ContactWorld::Impl::impulse_sums() const {
  std::vector<Momentum> sums(objects.size());
  for (std::size_t i = 0; i < contacts.size(); ++i) {
    const Vec3& impulse = contacts[i].impulse;
    sums[contacts[i].a].linear += impulse;
    sums[contacts[i].b].linear -= impulse;
    sums[contacts[i].a].angular += solved[i].a.arm.cross(impulse);
    sums[contacts[i].b].angular -= solved[i].b.arm.cross(impulse);
  }
  return sums;
}

/// Momentum balance of the rigid objects.
void ContactWorld::Impl::read_back_impulses(double dt) {
  const std::vector<Momentum> sums = impulse_sums();
  for (std::size_t i = 0; i < objects.size(); ++i) {
    Object& object = objects[i];
    if (!object.moves() || object.elastic) continue;
    const SolverBody solver_body = rigid_solver_body(object);
    if (object.kind == Kind::projectile) object.state.velocity += dt * gravity;
    object.state.velocity += solver_body.inverse_mass * sums[i].linear;
    object.state.angular_velocity += solver_body.inverse_inertia * sums[i].angular;
  }
}

/// Displacements that take out a share of the overlaps, as velocities of a solve of their own.
void ContactWorld::Impl::correct_positions(const std::vector<ContactConstraint>& constraints, double dt) {
  for (Object& object : objects) object.correction = {};
  std::vector<ContactConstraint> overlaps = constraints;
  bool any = false;
  for (std::size_t i = 0; i < overlaps.size(); ++i) {
    const Contact& contact = contacts[i];
    const double distance = distance_beyond(contact.distance, allowance(contact.a, contact.b));
    const double excess = -distance - kRestingFraction * smaller_radius(objects[contact.a], objects[contact.b]);
    overlaps[i].friction = 0;
    overlaps[i].impulse.setZero();
    overlaps[i].target_velocity = excess > 0 ? kCorrectionFraction * excess : -std::max(0.0, distance);
    any |= excess > 0;
  }
  if (!any) return;
  std::vector<SolverBody> moving;
  for (const Object& object : objects) moving.push_back(rigid_solver_body(object));
  solve_impulses(overlaps, moving, kRoughly);
  for (std::size_t i = 0; i < objects.size(); ++i)
    objects[i].correction = {moving[i].velocity, moving[i].angular_velocity};
  limit_lift(dt);
}

/// Of each group of objects that touch, corrections lift no more than the substep let fall or slowed down: energy does
/// not grow.
void ContactWorld::Impl::limit_lift(double dt) {
  const std::vector<int> groups = connected_groups(static_cast<int>(objects.size()), touching_pairs());
  std::vector<double> lifted(objects.size(), 0.0), lost(objects.size(), 0.0);
  for (std::size_t i = 0; i < objects.size(); ++i) {
    const Object& object = objects[i];
    if (!object.moves()) continue;
    const double mass = 1 / object.inverse_mass;
    lifted[groups[i]] -= mass * gravity.dot(object.correction.translation);
    lost[groups[i]] += kinetic_energy(object, object.first_velocity, object.first_spin) -
                       kinetic_energy(object, object.state.velocity, object.state.angular_velocity) +
                       mass * dt * gravity.dot(object.state.velocity);
  }
  for (std::size_t i = 0; i < objects.size(); ++i) {
    const double lift = lifted[groups[i]], fraction = lift > 0 ? std::clamp(lost[groups[i]] / lift, 0.0, 1.0) : 1;
    objects[i].correction.translation *= fraction;
    objects[i].correction.rotation *= fraction;
  }
}

}  // namespace griffith
