#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>

#include "sim/contact/bullet/contact_world.h"
#include "sim/contact/bullet/sweep.h"
#include "sim/core/rotation.h"

namespace griffith {

using namespace contact;

PlacedShape contact::placed(const Object& object, std::size_t part, const btTransform& place, double ground_height) {
  if (object.kind == Kind::ground) return {nullptr, btTransform::getIdentity(), ground_height};
  return {object.shape.parts[part].get(), place, 0};
}

bool contact::may_touch(const Object& a, const Vec3& start, const Vec3& displacement, const Object& b, double gap,
                        double ground_height) {
  if (b.kind == Kind::ground)
    return start.y() + std::min(0.0, displacement.y()) <= ground_height + a.shape.radius + gap;
  return nearest_distance(start - b.state.pose.translation, displacement) <= a.shape.radius + b.shape.radius + gap;
}

namespace {

/// Overlap of swept projectiles at a touch, as a fraction of their radius, so that the next detection finds the
/// contact.
constexpr double kTouchFraction = 1e-6;
/// Largest numbers of surfaces at which a projectile changes direction in one substep, and of parts that it pushes
/// ahead of itself.
constexpr int kMaxTurns = 4, kMaxPushed = 64;

/// Motion of `a` relative to `b`, which stays in its present place.
struct Sweep {
  const Object &a, &b;
  Vec3 start;         ///< start of a's center [m]
  Vec3 displacement;  ///< [m]
  double gap;         ///< gap that counts as touching [m]
};

btTransform moved_to(const Object& object, const Vec3& center) {
  return to_bullet(Pose{center, object.state.pose.rotation});
}

/// Calls `use` with the touch of each pair of convex parts that comes near enough, and b's part.
template <class Use>
void for_each_touch(const Sweep& sweep, double ground_height, Use use) {
  const auto& [a, b, start, displacement, gap] = sweep;
  if (!may_touch(a, start, displacement, b, gap, ground_height)) return;
  for (std::size_t i = 0; i < a.shape.parts.size(); ++i)
    for (std::size_t j = 0; j < b.part_count(); ++j) {
      const PlacedShape other = placed(b, j, moved_to(b, b.state.pose.translation), ground_height);
      if (const auto touch = first_touch(placed(a, i, moved_to(a, start), ground_height), displacement, other, gap))
        use(*touch, j);
    }
}

Quat rotated(const Quat& rotation, const Vec3& turn) {
  if (turn.isZero(0)) return rotation;
  return (Quat(rotation_by(turn)) * rotation).normalized();
}

/// Returns the place of an object after a fraction (0..1) of the substep in uniform motion. Projectiles have rotated
/// already.
Pose pose_after(const Object& object, double fraction, double dt) {
  Pose pose = object.state.pose;
  pose.translation += fraction * dt * object.mean_velocity(dt);
  if (object.kind != Kind::projectile)
    pose.rotation =
        rotated(pose.rotation, fraction * (dt * object.state.angular_velocity + object.correction.rotation));
  return pose;
}

/// Rotates a projectile; its angular momentum is conserved.
void turn(Object& object, const Mat3& rotation) {
  RigidState& state = object.state;
  const Quat before = state.pose.rotation;
  state.pose.rotation = (Quat(rotation) * before).normalized();
  const Vec3 own_spin = before.conjugate() * state.angular_velocity;
  const Quat back = state.pose.rotation.conjugate();
  const Vec3 momentum = before * (object.inverse_inertia.inverse() * own_spin);
  state.angular_velocity = state.pose.rotation * (object.inverse_inertia * (back * momentum));
}

/// Returns the velocity of an object at a point after a fraction of the substep [m/s].
Vec3 velocity_at(const Object& object, const Vec3& point, double fraction, double dt) {
  return object.state.velocity +
         object.state.angular_velocity.cross(point - pose_after(object, fraction, dt).translation);
}

/// True if a projectile pushes what it meets ahead of itself for the rest of the substep. At heavier objects it stops,
/// as swept bodies do: displacements across their paths, before the impulse, would change the angular momentum.
bool pushes(const Object& projectile, const Object& met) {
  constexpr double kLight = 0.25;  // of the projectile's mass
  return projectile.kind == Kind::projectile && met.kind == Kind::proxy && met.moves() &&
         projectile.inverse_mass < kLight * met.inverse_mass;
}

/// Returns the velocity with which an object continues that a projectile has met at `center` after a fraction of the
/// substep [m/s]: light ones and projectiles together with it, as after an inelastic impact.
Vec3 velocity_of_met(const Object& projectile, const Object& met, const Vec3& center, double fraction, double dt) {
  const double own = projectile.inverse_mass, other = met.inverse_mass;
  const Vec3 velocity = velocity_at(met, center, fraction, dt);
  if (met.kind == Kind::projectile && own + other > 0)
    return (other * projectile.state.velocity + own * met.state.velocity) / (own + other);
  if (!pushes(projectile, met)) return velocity;
  return (other * projectile.state.velocity + own * velocity) / (own + other);
}

/// Returns the rotation of a projectile by its spin in `dt` [s] and by its correction.
Mat3 turn_of(const Object& object, double dt, double fraction) {
  return rotation_by(fraction * object.correction.rotation) *
         free_turn(world_inertia(object), object.state.angular_velocity, fraction * dt);
}

}  // namespace

/// Rotates each projectile first, then moves it in its new orientation, so that it touches the objects that it meets.
/// Returns true if there are any.
bool ContactWorld::Impl::move_projectiles(double dt) {
  std::vector<std::size_t> projectiles;
  for (std::size_t i = 0; i < objects.size(); ++i)
    if (objects[i].kind == Kind::projectile && objects[i].moves()) projectiles.push_back(i);
  for (std::size_t i : projectiles) {
    if (!moves_rigidly[i]) objects[i].pushed_out = objects[i].correction.translation;
    turn_free(objects[i], dt);
  }
  std::vector<Vec3> ends;
  std::vector<Pushed> pushed;
  for (std::size_t i : projectiles) ends.push_back(swept_end(objects[i], dt, {}, pushed));
  for (const Pushed& of : pushed) objects[of.object].correction.translation += of.displacement;
  for (std::size_t i = 0; i < projectiles.size(); ++i) {
    Object& object = objects[projectiles[i]];
    const Vec3 mean = object.mean_velocity(dt);
    object.state.velocity += velocity_after(mean, ends[i] - object.state.pose.translation, dt) - mean;
    object.state.pose.translation = ends[i];
    object.correction = {};
    place(object);
  }
  return !projectiles.empty();
}

Vec3 ContactWorld::Impl::velocity_after(const Vec3& velocity, const Vec3& displacement, double dt) const {
  const double not_fallen = gravity.dot(dt * velocity - displacement);
  if (!(not_fallen > 0)) return velocity;
  const Vec3 down = gravity.normalized();
  const double fall = std::max(0.0, down.dot(velocity));
  return velocity + (std::sqrt(std::max(0.0, fall * fall - 2 * not_fallen)) - fall) * down;
}

/// Rotates a projectile until an object is in the way: contacts stop it there after the next detection.
void ContactWorld::Impl::turn_free(Object& object, double dt) {
  constexpr double kLargestTurn = 0.2, kMinTurn = 1e-3;  // [rad]
  if (object.is_sphere()) {
    turn(object, turn_of(object, dt, 1));
    return place(object);
  }
  const double allowed = std::max<double>(deepest_overlap(object), object.shape.parts.front()->getMargin());
  const double whole = (dt * object.state.angular_velocity + object.correction.rotation).norm();
  double left = 1, fraction = std::clamp(kLargestTurn / std::max(whole, kMinTurn), 0.01, 1.0);
  while (left > 0 && fraction * whole >= std::min(left * whole, kMinTurn)) {
    const RigidState before = object.state;
    turn(object, turn_of(object, dt, fraction));
    place(object);
    if (deepest_overlap(object) <= allowed) {
      left -= fraction;
      fraction = std::min(fraction, left);
      continue;
    }
    object.state = before;
    place(object);
    fraction /= 2;
  }
}

/// Returns the deepest overlap with objects other than the ground, out of which contacts lead at any depth [m].
double ContactWorld::Impl::deepest_overlap(const Object& object) const {
  double deepest = 0;
  const Vec3& center = object.state.pose.translation;
  for (const Object& other : objects) {
    if (&other == &object || !other.exists || other.kind == Kind::ground) continue;
    if (!may_touch(object, center, Vec3::Zero(), other, 0, ground_height)) continue;
    for (std::size_t part = 0; part < other.shape.parts.size(); ++part) {
      const PlacedShape shape = placed(other, part, moved_to(other, other.state.pose.translation), ground_height);
      deepest =
          std::max(deepest, -separation(placed(object, 0, moved_to(object, center), ground_height), shape).distance);
    }
  }
  return deepest;
}

bool ContactWorld::Impl::LeftSurface::is(const Object& other, std::size_t other_part, const Vec3& other_normal) const {
  constexpr double kSameNormal = 0.999;  // the cosine
  return object == &other && (part == other_part || normal.dot(other_normal) > kSameNormal);
}

/// Returns the place of a projectile after `dt` among the others in uniform motion. After slow touches it slides along
/// the surface. At an impact it continues together with what is light, and adds the displacement of that to `pushed`;
/// anything else stops it for the rest of `dt`, or pushes it on, no faster than before. The next detection thus finds
/// both in contact.
Vec3 ContactWorld::Impl::swept_end(const Object& projectile, double dt, const SweepRule& rule,
                                   std::vector<Pushed>& pushed) const {
  Vec3 center = projectile.state.pose.translation, velocity = projectile.mean_velocity(dt);
  double fraction = 0;
  std::vector<LeftSurface> parting;
  for (int turns = 0, pushes_made = 0; turns < kMaxTurns && pushes_made < kMaxPushed;) {
    const Vec3 before = velocity;
    for (const TouchAhead& next : touches_ahead(projectile, center, velocity, fraction, dt, rule)) {
      const Vec3 local_normal = pose_after(*next.met, next.fraction, dt).rotation.conjugate() * next.normal;
      if (std::ranges::any_of(parting,
                              [&](const LeftSurface& left) { return left.is(*next.met, next.part, local_normal); }))
        continue;
      parting.push_back({next.met, next.part, local_normal});
      center += (next.fraction - fraction) * dt * velocity;
      fraction = next.fraction;
      velocity = velocity_at_touch(projectile, velocity, next, center, dt);
      if (velocity == before) continue;
      const bool pushes_it = pushes(projectile, *next.met);
      ++(pushes_it ? pushes_made : turns);
      const double ahead = next.normal.dot(velocity - velocity_at(*next.met, center, fraction, dt));
      if (pushes_it && ahead < 0)
        pushed.push_back(
            {static_cast<std::size_t>(next.met - objects.data()), (1 - fraction) * dt * ahead * next.normal});
      break;
    }
    if (velocity == before) return center + (1 - fraction) * dt * velocity;
  }
  return center;
}

/// Returns the velocity of a projectile after a touch: if slow, it slides; after an impact it stops or is pushed on, no
/// faster than before.
Vec3 ContactWorld::Impl::velocity_at_touch(const Object& projectile, Vec3 velocity, const TouchAhead& touch,
                                           const Vec3& center, double dt) const {
  const double pushed = touch.normal.dot(velocity_of_met(projectile, *touch.met, center, touch.fraction, dt));
  const double approach = pushed - touch.normal.dot(velocity), speed = projectile.mean_velocity(dt).norm();
  if (approach <= 0) return velocity;
  const double came = touch.fraction * dt * (projectile.state.velocity - touch.met->state.velocity).norm();
  const bool just_solved = came < 10 * kTouchFraction * projectile.shape.radius;
  velocity += approach * touch.normal;
  const bool stops = approach > touching_speed(projectile, *touch.met, dt) && !just_solved;
  if (stops && !pushes(projectile, *touch.met)) velocity = pushed * touch.normal;
  return velocity * (speed / std::max({velocity.norm(), speed, std::numeric_limits<double>::min()}));
}

/// Returns the depth to which a projectile may penetrate a proxy [m]. An elastic body deforms where it is touched,
/// which the solve knows but its undeformed proxy does not show.
double ContactWorld::Impl::allowed_depth(const Object& projectile, const Object& other) const {
  constexpr double kElasticFraction = 0.5;  // fraction of a sphere's radius: its center stays outside
  const bool yields_now = other.elastic && std::any_of(contacts.begin(), contacts.end(), [&](const Contact& contact) {
                            const Object &a = objects[contact.a], &b = objects[contact.b];
                            return (&a == &projectile && &b == &other) || (&a == &other && &b == &projectile);
                          });
  if (!yields_now) return kTouchFraction * projectile.shape.radius;
  return projectile.is_sphere() ? kElasticFraction * projectile.shape.radius
                                : projectile.shape.parts.front()->getMargin();
}

namespace {

/// True if the bounding spheres of two objects touch while the first moves from `center` by `displacement` and the
/// second moves and rotates from a fraction of the substep on.
bool may_come_near(const Object& object, const Vec3& center, const Vec3& displacement, const Object& other,
                   double fraction, double dt) {
  constexpr double kRounding = 1 + 1e-9;
  if (other.kind == Kind::ground) return true;
  const Vec3 whole = dt * other.state.velocity + other.correction.translation;
  const Vec3 apart = center - other.state.pose.translation - fraction * whole;
  const double reach = object.shape.radius + other.shape.radius;
  return nearest_distance(apart, displacement - (1 - fraction) * whole) <= kRounding * reach + 1e-12 * apart.norm();
}

/// Returns the number of pieces in which a path through the frame of an object is straight enough for a projectile: the
/// object rotates, so that the path is bent.
int straight_pieces(const Object& projectile, const Object& other, double fraction, double dt) {
  constexpr double kSagitta = 0.01;  // of the projectile's radius
  constexpr double kMost = 256;
  const double turn = (1 - fraction) * (dt * other.state.angular_velocity + other.correction.rotation).norm();
  if (other.kind == Kind::ground || turn == 0) return 1;
  const double size = projectile.shape.radius, distance = other.shape.radius + size;
  return static_cast<int>(std::clamp(std::ceil(turn * std::sqrt(distance / (8 * kSagitta * size))), 1.0, kMost));
}

}  // namespace

/// Adds the touches of a projectile in uniform motion after a fraction of the substep with one other object, which is
/// examined in its own frame, so its rotation counts.
void ContactWorld::Impl::add_touches(const Object& projectile, const Object& other, const Vec3& center,
                                     const Vec3& velocity, double fraction, double dt, double slow,
                                     std::vector<TouchAhead>& touches) const {
  const double gap = -allowed_depth(projectile, other);
  const Pose& present = other.state.pose;
  const auto in_its_frame = [&](double at) {
    return pose_after(other, at, dt).to_local(center + (at - fraction) * dt * velocity);
  };
  const int pieces = straight_pieces(projectile, other, fraction, dt);
  for (int piece = 0; piece < pieces; ++piece) {
    const double from = fraction + (1 - fraction) * piece / pieces,
                 to = fraction + (1 - fraction) * (piece + 1) / pieces;
    const Vec3 start = in_its_frame(from), end = in_its_frame(to);
    const Sweep sweep{projectile, other, present.to_world(start), present.rotation * (end - start), gap};
    if (sweep.displacement.norm() < slow / pieces) continue;
    for_each_touch(sweep, ground_height, [&](const Touch& touch, std::size_t part) {
      if (!comes_nearer(sweep.displacement, touch.normal)) return;  // overlaps, and leads out
      const double touch_fraction = from + touch.fraction * (to - from);
      const Quat turn = pose_after(other, touch_fraction, dt).rotation * present.rotation.conjugate();
      touches.push_back({touch_fraction, &other, turn * touch.normal, part});
    });
  }
}

/// Returns the touches of a projectile in uniform motion after a fraction of the substep, in order.
std::vector<ContactWorld::Impl::TouchAhead> ContactWorld::Impl::touches_ahead(const Object& projectile,
                                                                              const Vec3& center, const Vec3& velocity,
                                                                              double fraction, double dt,
                                                                              const SweepRule& rule) const {
  constexpr double kRoom = 1.001;
  std::vector<TouchAhead> touches;
  const Vec3 displacement = (1 - fraction) * dt * velocity, reach = Vec3::Constant(kRoom * projectile.shape.radius);
  const Box swept{center + displacement.cwiseMin(0) - reach, center + displacement.cwiseMax(0) + reach};
  for (const int index : objects_near(swept)) {
    const Object& other = objects[index];
    if (&other == &projectile || !other.exists || !may_come_near(projectile, center, displacement, other, fraction, dt))
      continue;
    if (rule.stops && !rule.stops(ProxyId(&other - objects.data()))) continue;
    add_touches(projectile, other, center, velocity, fraction, dt, rule.slow, touches);
  }
  std::ranges::stable_sort(touches, {}, &TouchAhead::fraction);
  return touches;
}

}  // namespace griffith
