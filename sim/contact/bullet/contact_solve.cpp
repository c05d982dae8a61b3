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

Vec3 rigid_velocity(const SolverBody& solver_body, const ContactEnd& end) {
  return solver_body.velocity + solver_body.angular_velocity.cross(end.arm);
}

}  // namespace

double contact::kinetic_energy(const Object& object, const Vec3& velocity, const Vec3& spin) {
  const Vec3 own_spin = object.state.pose.rotation.conjugate() * spin;
  return 0.5 *
         (velocity.squaredNorm() / object.inverse_mass + own_spin.dot(object.inverse_inertia.inverse() * own_spin));
}

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

/// Those of groups with something elastic. Sweeps down through a pile carry its load at once.
std::vector<ContactConstraint> ContactWorld::Impl::constraints(double dt) const {
  std::vector<ContactConstraint> made(elastic_contacts.size());
  for (std::size_t i = 0; i < made.size(); ++i) {
    const Contact& contact = contacts[elastic_contacts[i]];
    const Object &a = objects[contact.a], &b = objects[contact.b];
    ContactConstraint& row = made[i];
    row.a = {static_cast<int>(contact.a.index()), -1, contact.position - a.state.pose.translation};
    row.b = {static_cast<int>(contact.b.index()), -1, contact.position - b.state.pose.translation};
    row.axes = contact_axes(contact.normal);
    row.friction = std::sqrt(a.surface.friction * b.surface.friction);
    // The last impulse, as a mean force: contacts hardly turn.
    row.impulse = dt * (row.axes.transpose() * remembered_force(memories[elastic_contacts[i]]));
    row.impulse[0] = std::max(0.0, row.impulse[0]);
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

int ContactWorld::Impl::solve(double dt, std::span<const ElasticObject> elastic, std::span<const HingedObject> hinges) {
  assert(dt > 0);
  for (Object& object : objects) object.elastic = false, object.hinge = -1;
  for (const ElasticObject& object : elastic) objects[object.object].elastic = true;
  hinged.assign(hinges.begin(), hinges.end());
  for (std::size_t i = 0; i < hinged.size(); ++i) objects[hinged[i].object].hinge = static_cast<int>(i);
  inherit_forces();
  split_groups();
  const int work = solve_rigid_groups(dt);
  prepare_elastic_groups(dt, elastic);
  return work;
}

/// Finds the laws of the contacts that the owner is to solve.
void ContactWorld::Impl::prepare_elastic_groups(double dt, std::span<const ElasticObject> elastic) {
  row_of.assign(contacts.size(), -1);
  for (std::size_t i = 0; i < elastic_contacts.size(); ++i) row_of[elastic_contacts[i]] = static_cast<int>(i);
  solved = constraints(dt);
  free_velocities.assign(solved.size(), Vec3::Zero());
  if (solved.empty()) return;
  const std::vector<SolverBody> solver_bodies = rigid_solver_bodies(dt);
  std::vector<const ElasticObject*> elastic_of(objects.size(), nullptr);
  for (const ElasticObject& object : elastic) {
    elastic_of[object.object] = &object;
    for (std::size_t point = 0; point < object.contacts.size(); ++point) {
      ContactConstraint& row = solved[row_of[object.contacts[point]]];
      (row.a.solver_body == object.object.index() ? row.a : row.b).point = static_cast<int>(point);
    }
  }
  const auto free_velocity = [&](const ContactEnd& end) {
    if (const ElasticObject* object = elastic_of[end.solver_body]) return Vec3(object->free_velocities.col(end.point));
    return rigid_velocity(solver_bodies[end.solver_body], end);
  };
  for (std::size_t i = 0; i < solved.size(); ++i) {
    Contact& contact = contacts[elastic_contacts[i]];
    free_velocities[i] = free_velocity(solved[i].a) - free_velocity(solved[i].b);
    contact.approach = -contact.normal.dot(free_velocities[i]);
    contact.impulse.setZero();
    solved[i].target_velocity = target_velocity(contact, dt);
  }
}

std::vector<std::vector<int>> ContactWorld::Impl::elastic_groups() const {
  const std::vector<int> groups = connected_groups(static_cast<int>(objects.size()), touching_pairs());
  std::vector<int> index_of(objects.size(), -1);
  std::vector<std::vector<int>> found;
  for (const int i : elastic_contacts) {
    const ProxyId object = objects[contacts[i].a].responds() ? contacts[i].a : contacts[i].b;
    if (!objects[object].responds()) continue;
    int& index = index_of[groups[object]];
    if (index < 0) {
      index = static_cast<int>(found.size());
      found.emplace_back();
    }
    found[index].push_back(i);
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
  for (const int i : elastic_contacts) {
    const Contact& contact = contacts[i];
    const double pushing = contact.normal.dot(contact.impulse);
    remember_force(memories[i], (contact.impulse + std::max(0.0, -pushing) * contact.normal) / dt);
  }
}

void ContactWorld::Impl::note_carried() {
  for (Object& object : objects) object.carried = false;
  for (const Contact& contact : contacts)
    for (const auto& [one, other] : {std::pair(contact.a, contact.b), std::pair(contact.b, contact.a)})
      if (objects[one].kind == Kind::ground && !contact.impulse.isZero(0))
        objects[other].carried = objects[other].mobility == Mobility::kinematic;
}

void ContactWorld::Impl::advance(double dt) {
  remember_impulses(dt);
  note_carried();
  read_back_impulses(dt);
  resist_rolling();
  correct_positions(solved, dt);
  move_rigid_groups(dt);
  strays = find_strays(dt);
  if (move_projectiles(dt)) strays = find_strays(dt);
}

std::vector<ContactWorld::Impl::Momentum> ContactWorld::Impl::impulse_sums() const {
  std::vector<Momentum> sums(objects.size());
  for (const Contact& contact : contacts) {
    const Vec3& impulse = contact.impulse;
    sums[contact.a].linear += impulse;
    sums[contact.b].linear -= impulse;
    sums[contact.a].angular += (contact.position - objects[contact.a].state.pose.translation).cross(impulse);
    sums[contact.b].angular -= (contact.position - objects[contact.b].state.pose.translation).cross(impulse);
  }
  return sums;
}

/// Momentum balance of the rigid objects.
void ContactWorld::Impl::read_back_impulses(double dt) {
  const std::vector<Momentum> sums = impulse_sums();
  for (std::size_t i = 0; i < objects.size(); ++i) {
    Object& object = objects[i];
    if (!object.moves() || object.elastic) continue;
    if (object.kind == Kind::projectile) object.state.velocity += dt * gravity;
    if (sums[i].linear.isZero(0)) continue;
    const SolverBody solver_body = rigid_solver_body(object);
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
    const Contact& contact = contacts[elastic_contacts[i]];
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
    if (!object.moves() || moves_rigidly[i]) continue;
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
