#include <Eigen/LU>
#include <algorithm>
#include <cassert>
#include <cmath>

#include "sim/contact/bullet/contact_world.h"
#include "sim/contact/rigid_overlaps.h"
#include "sim/core/parallel.h"
#include "sim/geometry/disjoint_sets.h"

namespace griffith {

using namespace contact;

namespace {

/// Fraction of an overlap that is removed in a substep; overlap, as a fraction of the smaller radius, that remains so
/// that objects at rest stay in contact.
constexpr double kCorrectionFraction = 0.1, kRestingFraction = 3e-4;

Mat3 contact_axes(const Vec3& normal) {
  Mat3 axes;
  axes.col(0) = normal;
  axes.col(1) = normal.unitOrthogonal();
  axes.col(2) = normal.cross(axes.col(1));
  return axes;
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

/// Returns the law of a contact in a group with a deformable object, without its velocities.
ContactWorld::Law ContactWorld::Impl::law_of(const Contact& contact, const Memory& memory, double dt) const {
  const Object &a = objects[contact.a], &b = objects[contact.b];
  Law law;
  law.arm_a = contact.position - center(a);
  law.arm_b = contact.position - center(b);
  law.axes = contact_axes(contact.normal);
  law.friction = std::sqrt(a.surface.friction * b.surface.friction);
  // The last impulse, as a mean force: contacts hardly turn.
  law.guess = dt * (law.axes.transpose() * remembered_force(memory));
  law.guess[0] = std::max(0.0, law.guess[0]);
  if (law.friction == 0) law.guess.tail<2>().setZero();
  return law;
}

/// Returns the approach speed below which a contact is no impact: that of a fall from rest within a substep, and of a
/// fall through a small fraction of the smaller object's size [m/s].
double ContactWorld::Impl::touching_speed(const Object& a, const Object& b, double dt) const {
  constexpr double kSettledFraction = 0.06;
  return std::max(2 * dt * gravity.norm(), kSettledFraction * std::sqrt(gravity.norm() * smaller_radius(a, b)));
}

/// True for an impact: a gap that closes in this substep is hit now, at full speed, rather than in part now and in part
/// in the next one.
bool ContactWorld::Impl::strikes(const Contact& contact, double dt) const {
  return contact.approach > touching_speed(objects[contact.a], objects[contact.b], dt) &&
         contact.approach * dt > contact.distance;
}

/// True for a free object that nothing carries: one that does not stand still.
bool ContactWorld::Impl::falls(const Object& object, double dt) const {
  return object.is_free() && object.first_velocity.norm() > 0.5 * dt * gravity.norm();
}

/// Returns the separation speed after an impact, now instead of when the gap will have closed, for e² of the height of
/// the fall. In these substeps, a fall with g conserves v²/2 + g y + g dt v/2, v downward.
double ContactWorld::Impl::rebound_speed(const Contact& contact, double dt) const {
  const Object &a = objects[contact.a], &b = objects[contact.b];
  const double restitution = std::min(a.surface.restitution, b.surface.restitution);
  const auto gain_of = [&](int falling) { return -dt * falling * contact.normal.dot(gravity); };
  const double gain = gain_of(falls(a, dt) - falls(b, dt));  // of the approach, in this substep
  const double before = contact.approach - gain_of(a.is_free() - b.is_free()),
               climb = 2 * gain / dt * std::max(0.0, contact.distance);
  // The top of the steps lies up to g dt²/8 above that of the fall.
  const double over = gain * gain / 4;
  const double left = restitution * restitution * (before * before + gain * before + climb) - climb - over;
  if (left <= 0 || before + gain <= 0) return 0;
  const double speed = -gain / 2 + std::sqrt(gain * gain / 4 + left);
  return speed * contact.approach / (before + gain);  // alone, what is carried would fall, too
}

double ContactWorld::Impl::target_velocity(const Contact& contact, double dt) const {
  if (!strikes(contact, dt)) return -std::max(0.0, contact.distance) / dt;
  const Object &a = objects[contact.a], &b = objects[contact.b];
  if (!a.rebounds || !b.rebounds || allowance(contact.a, contact.b) > 0) return 0;
  return rebound_speed(contact, dt);
}

int ContactWorld::Impl::solve(double dt, std::span<const ElasticObject> elastic, std::span<const HingedObject> hinges) {
  assert(dt > 0);
  for (Object& object : objects) object.elastic = false, object.rebounds = true, object.hinge = -1;
  for (const ElasticObject& object : elastic) {
    objects[object.object].elastic = true;
    objects[object.object].rebounds = object.rebounds_by_law;
  }
  hinged.assign(hinges.begin(), hinges.end());
  for (std::size_t i = 0; i < hinged.size(); ++i) objects[hinged[i].object].hinge = static_cast<int>(i);
  inherit_forces();
  split_groups();
  const int work = solve_rigid_groups(dt);
  prepare_elastic_groups(dt, elastic);
  scratch.is_solved = true;
  return work;
}

/// Finds the laws of the contacts that the owner is to solve.
void ContactWorld::Impl::prepare_elastic_groups(double dt, std::span<const ElasticObject> elastic) {
  law_of_contact.assign(contacts.size(), -1);
  laws.clear();
  for (const int i : elastic_contacts) add_law(i, dt);
  for (const ElasticObject& object : elastic)
    for (std::size_t point = 0; point < object.contacts.size(); ++point) {
      const int i = object.contacts[point];
      const Vec3 velocity = object.free_velocities.col(static_cast<Eigen::Index>(point));
      laws[law_of_contact[i]].free_velocity += contacts[i].a == object.object ? velocity : Vec3(-velocity);
    }
  for (const int i : elastic_contacts) set_target(i, dt);
}

/// Adds the law of a contact, with the velocities of its rigid sides.
void ContactWorld::Impl::add_law(int contact, double dt) {
  const Contact& of = contacts[contact];
  law_of_contact[contact] = static_cast<int>(laws.size());
  Law& law = laws.emplace_back(law_of(of, memories[contact], dt));
  law.free_velocity = rigid_velocity(of.a, law.arm_a, dt) - rigid_velocity(of.b, law.arm_b, dt);
}

/// Sets what a contact's law asks for, once its velocity is known.
void ContactWorld::Impl::set_target(int contact, double dt) {
  Contact& of = contacts[contact];
  Law& law = laws[law_of_contact[contact]];
  of.approach = -of.normal.dot(law.free_velocity);
  of.impulse.setZero(), of.couple.setZero();
  law.target_velocity = target_velocity(of, dt);
}

/// True if a group is at rest, small, and its impulses are not found yet.
bool ContactWorld::Impl::is_unsettled(const RigidGroup& group, double dt) const {
  constexpr std::size_t kMostBodies = 64, kMostContacts = 800;
  constexpr double kSolved = 1.5e-4, kAtRest = 2;  // of the speed that gravity adds in the substep
  const double added = dt * gravity.norm();
  const auto rests = [&](int i) { return objects[i].hinge < 0 && objects[i].speed() < kAtRest * added; };
  return group.change > kSolved * added && group.bodies.size() <= kMostBodies &&
         group.contacts.size() <= kMostContacts && std::ranges::all_of(group.bodies, rests);
}

void ContactWorld::Impl::leave_unsettled_groups(double dt) {
  std::vector<int> left;
  std::erase_if(rigid_groups, [&](const RigidGroup& group) {
    if (!is_unsettled(group, dt)) return false;
    for (const int body : group.bodies) moves_rigidly[body] = false;
    for (const int row : group.contacts) left.push_back(scratch.contact_of_row[row]);
    return true;
  });
  for (const int contact : left) {
    add_law(contact, dt);
    set_target(contact, dt);
  }
  elastic_contacts.insert(elastic_contacts.end(), left.begin(), left.end());
  std::ranges::sort(elastic_contacts);
}

/// Returns the velocity of a point of a rigid object without impulses; zero for an elastic one, whose owner knows it
/// [m/s].
Vec3 ContactWorld::Impl::rigid_velocity(ProxyId id, const Vec3& arm, double dt) const {
  const Object& object = objects[id];
  if (object.elastic) return Vec3::Zero();
  if (object.hinge >= 0) return hinged[object.hinge].spin.cross(arm);
  const Vec3 velocity = object.state.velocity + object.state.angular_velocity.cross(arm);
  return object.kind == Kind::projectile && object.moves() ? Vec3(velocity + dt * gravity) : velocity;
}

std::vector<std::vector<int>> ContactWorld::Impl::elastic_groups() const {
  const std::vector<int> groups = connected_groups(static_cast<int>(objects.size()), touching_pairs());
  std::vector<int> index_of(objects.size(), -1);
  std::vector<std::vector<int>> found;
  for (const int i : elastic_contacts) {
    const ProxyId object = objects[contacts[i].a].yields() ? contacts[i].a : contacts[i].b;
    if (!objects[object].yields()) continue;
    int& index = index_of[groups[object]];
    if (index < 0) {
      index = static_cast<int>(found.size());
      found.emplace_back();
    }
    found[index].push_back(i);
  }
  return found;
}

/// Returns the pairs whose impulses affect each other.
std::vector<std::pair<int, int>> ContactWorld::Impl::touching_pairs() const {
  std::vector<std::pair<int, int>> touching;
  for (const Contact& contact : contacts)
    if (objects[contact.a].yields() && objects[contact.b].yields())
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
  for (const Contact& contact : contacts) {
    Object &a = objects[contact.a], &b = objects[contact.b];
    if (!a.is_free() && !b.is_free() && !contact.impulse.isZero(0)) a.carried = b.carried = true;
  }
}

void ContactWorld::Impl::advance(double dt) {
  remember_impulses(dt);
  note_carried();
  read_back_impulses(dt);
  resist_rolling();
  push_elastic_groups_apart(dt);
  for (Object& object : objects) object.correction.rotation += dt * object.spin_taken;
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
    sums[contact.a].angular += contact.couple;
    sums[contact.b].angular += contact.couple;
  }
  return sums;
}

/// Updates the momentum of the rigid objects.
void ContactWorld::Impl::read_back_impulses(double dt) {
  const std::vector<Momentum> sums = impulse_sums();
  for (std::size_t i = 0; i < objects.size(); ++i) {
    Object& object = objects[i];
    if (!object.moves() || object.elastic) continue;
    if (object.kind == Kind::projectile) object.state.velocity += dt * gravity;
    if (sums[i].linear.isZero(0)) continue;
    object.state.velocity += object.inverse_mass * sums[i].linear;
    object.state.angular_velocity += inverse_world_inertia(object) * sums[i].angular;
  }
}

/// Moves groups with elastic objects out of their overlaps, all objects as rigid ones.
void ContactWorld::Impl::push_elastic_groups_apart(double dt) {
  for (Object& object : objects) object.correction = {};
  const auto overlaps = [&](int i) { return overlap_contact(contacts[i]).distance < 0; };
  if (std::ranges::none_of(elastic_contacts, overlaps)) return;
  std::vector<RigidBody> bodies(objects.size());
  for (std::size_t i = 0; i < objects.size(); ++i) {
    bodies[i].moves = objects[i].moves();
    if (!bodies[i].moves) continue;
    bodies[i].inverse_mass = objects[i].inverse_mass;
    bodies[i].inverse_inertia = inverse_world_inertia(objects[i]);
  }
  std::vector<RigidContact> rows;
  std::vector<RigidGroup> groups;
  for (const std::vector<int>& group : elastic_groups()) {
    std::vector<int>& of_group = groups.emplace_back().contacts;
    for (const int i : group) {
      if (!objects[contacts[i].a].moves() && !objects[contacts[i].b].moves()) continue;
      of_group.push_back(static_cast<int>(rows.size()));
      rows.push_back(overlap_contact(contacts[i]));
    }
  }
  push_apart(bodies, rows, groups, kCorrectionFraction);
  for (std::size_t i = 0; i < objects.size(); ++i) objects[i].correction = {bodies[i].push, bodies[i].push_rotation};
  limit_lift(dt);
}

/// Returns a contact of which only the overlap counts.
RigidContact ContactWorld::Impl::overlap_contact(const Contact& contact) const {
  const Object &a = objects[contact.a], &b = objects[contact.b];
  RigidContact row;
  row.a = static_cast<int>(contact.a.index());
  row.b = static_cast<int>(contact.b.index());
  row.normal = contact.normal;
  row.arm_a = contact.position - a.state.pose.translation;
  row.arm_b = contact.position - b.state.pose.translation;
  row.fallen = gravity.dot(contact.position);
  row.distance = distance_beyond(contact.distance, allowance(contact.a, contact.b));
  row.resting = kRestingFraction * smaller_thickness(a, b);
  return row;
}

/// Limits the lift by corrections in each group of touching objects to the energy that falls and contacts took from it
/// in the substep, so energy does not grow.
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

double ContactWorld::overlap_at_rest(ProxyId object) const {
  return kRestingFraction * impl_->objects[object].shape.radius;
}

}  // namespace griffith
