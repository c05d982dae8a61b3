#include <algorithm>
#include <cmath>

#include "sim/contact/bullet/contact_world.h"

namespace griffith {

using namespace contact;

namespace {

/// Largest displacement of a point of a still object as a fraction of the radius.
constexpr double kStillFraction = 0.01;
/// Fraction of the speed of a fall from the object's own height that does not disturb sleepers.
constexpr double kQuietFraction = 0.04;
/// Returns the response of a rigid object's spin to torques [1/(kg·m²)]; zero if it does not rotate freely.
Mat3 spin_mobility(const Object& object) {
  return object.moves() && !object.elastic ? inverse_world_inertia(object) : Mat3::Zero();
}

void set_asleep(Object& object, bool asleep) {
  object.asleep = asleep;
  object.still_time = asleep ? 0 : ContactWorld::kTimeToSleep / 2;  // it may soon fall asleep again
  object.resting_place = object.state.pose;
  object.active = !asleep;
}

}  // namespace

bool contact::has_left(const Pose& then, const Pose& now, double distance, double radius) {
  const double turned = 2 * (now.rotation.conjugate() * then.rotation).vec().norm() * radius;
  return (now.translation - then.translation).norm() + turned > distance;
}

double ContactWorld::Impl::quiet_speed(const Object& object) const {
  return kQuietFraction * std::sqrt(gravity.norm() * object.shape.radius);
}

/// Reduces the spin of rolling or rocking objects by each contact; through friction, their speed follows. In this
/// substep they still turn as they move.
void ContactWorld::Impl::resist_rolling() {
  for (Object& object : objects) object.spin_taken.setZero();
  for (std::size_t i = 0; i < contacts.size(); ++i) {
    const Contact& contact = contacts[i];
    const double pushing = contact.normal.dot(contact.impulse);
    const Object &a = objects[contact.a], &b = objects[contact.b];
    const double resistance = std::max(a.surface.rolling_resistance, b.surface.rolling_resistance);
    if (!(pushing > 0) || resistance == 0) continue;
    const auto arm = [&](const Object& object) {
      return object.is_free() ? (contact.position - object.state.pose.translation).norm() : 0;
    };
    const double a_arm = arm(a), b_arm = arm(b);
    resist_rolling(contact, resistance * pushing * (a_arm > 0 && b_arm > 0 ? std::min(a_arm, b_arm) : a_arm + b_arm));
  }
}

/// Takes relative spin by an angular impulse of at most `limit` [N·m·s].
void ContactWorld::Impl::resist_rolling(const Contact& contact, double limit) {
  Object &a = objects[contact.a], &b = objects[contact.b];
  const Mat3 mobility = spin_mobility(a) + spin_mobility(b);
  const Vec3 spin = a.state.angular_velocity - b.state.angular_velocity;
  if (mobility.isZero(0) || spin.isZero(0)) return;
  const Vec3 axis = spin.normalized();
  const double stopping = spin.norm() / axis.dot(mobility * axis);
  const Vec3 impulse = std::min(limit, stopping) * axis;
  const auto change = [&](Object& object, double side) {
    const Vec3 taken = side * (spin_mobility(object) * impulse);
    object.state.angular_velocity -= taken;
    object.spin_taken += taken;
  };
  change(a, 1);
  change(b, -1);
}

/// Puts objects to sleep that have been still for long enough, like all their neighbors.
void ContactWorld::Impl::fall_asleep(double dt) {
  if (gravity.isZero(0)) return;  // without gravity slow objects drift on
  for (Object& object : objects) {
    if (!object.may_sleep()) continue;
    if (object.settled) {
      object.still_time = *object.settled ? kTimeToSleep : 0;
    } else if (object.elastic || has_left(object.resting_place, object.state.pose, kStillFraction * object.shape.radius,
                                          object.shape.radius)) {
      object.resting_place = object.state.pose;
      object.still_time = 0;
    } else {
      object.still_time += dt;
    }
  }
  const auto is_restless = [](const Object& object) { return object.may_sleep() && object.still_time < kTimeToSleep; };
  std::vector<bool> stays_awake(objects.size(), false);
  for (const Contact& contact : contacts) {
    if (is_restless(objects[contact.b])) stays_awake[contact.a] = true;
    if (is_restless(objects[contact.a])) stays_awake[contact.b] = true;
  }
  for (std::size_t i = 0; i < objects.size(); ++i) {
    if (stays_awake[i] || !objects[i].may_sleep() || is_restless(objects[i])) continue;
    objects[i].state.velocity = objects[i].state.angular_velocity = Vec3::Zero();
    set_asleep(objects[i], true);
  }
}

void ContactWorld::Impl::wake_up(ProxyId id) {
  if (objects[id].asleep) set_asleep(objects[id], false);
}

void ContactWorld::Impl::wake_neighbors(ProxyId id) {
  for (const Pair& pair : pairs)
    if ((pair.a == id.index() || pair.b == id.index()) && pair.count > 0)
      wake_up(ProxyId(pair.a == id.index() ? pair.b : pair.a));
}

/// Wakes objects that touch an object which is not quiet or has just left its place.
void ContactWorld::Impl::wake_disturbed(double dt) {
  for (const Pair& pair : pairs) {
    if (objects[pair.a].asleep == objects[pair.b].asleep || pair.count == 0) continue;
    const int sleeper = objects[pair.a].asleep ? pair.a : pair.b;
    const Object& disturber = objects[sleeper == pair.a ? pair.b : pair.a];
    if (!disturber.active) continue;
    if (disturber.still_time > 0 && disturber.speed() <= quiet_speed(objects[sleeper])) continue;
    const Manifold& manifold = manifolds[pair.manifold];
    const auto near = [&](const Manifold::Point& point) {
      const Contact contact = contact_at(pair, manifold, point, objects[pair.a].place, objects[pair.b].place);
      return nearness_of(pair, contact, dt) == Nearness::near;
    };
    if (std::ranges::any_of(manifold.listed(), near)) wake_up(ProxyId(sleeper));
  }
}

void ContactWorld::fall_asleep(double dt) { impl_->fall_asleep(dt); }
void ContactWorld::set_settled(ProxyId object, std::optional<bool> settled) {
  impl_->objects[object].settled = settled;
}
bool ContactWorld::asleep(ProxyId object) const { return impl_->objects[object].asleep; }
void ContactWorld::wake_up(ProxyId object) { impl_->wake_up(object); }

}  // namespace griffith
