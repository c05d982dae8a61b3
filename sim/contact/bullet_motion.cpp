#include <algorithm>

#include "sim/contact/bullet_sweep.h"
#include "sim/contact/bullet_world.h"

namespace griffith {

using namespace contact;

namespace {

/// Swept spheres come to rest overlapping by this share of their radius, so that the next detection sees the contact.
constexpr double kTouchShare = 1e-6;
/// A sphere slides along this many surfaces in one substep at most.
constexpr int kMaxTouches = 4;

/// Two objects in uniform motion, seen from the second.
struct Encounter {
  const Object &a, &b;
  Vec3 a_shift, b_shift;  ///< from their present places to the start of the motion [m]
  Vec3 displacement;      ///< of a relative to b [m]
  double gap;             ///< that counts as touching [m]
};

PlacedShape placed(const Object& object, std::size_t part, const Vec3& shift, double ground_height) {
  if (object.kind == Kind::ground) return {nullptr, btTransform::getIdentity(), ground_height};
  PlacedShape shape{object.shape.parts[part].get(), object.body->getWorldTransform(), 0};
  shape.transform.setOrigin(shape.transform.getOrigin() + to_bullet(shift));
  return shape;
}

/// Whether the spheres round the two objects come near enough to touch.
bool may_touch(const Encounter& encounter, double ground_height) {
  const auto& [a, b, a_shift, b_shift, displacement, gap] = encounter;
  const Vec3 start = a.state.pose.translation + a_shift;
  if (b.kind == Kind::ground) return start.y() + displacement.y() <= ground_height + a.shape.radius + gap;
  const Vec3 apart = start - b.state.pose.translation - b_shift;
  const double length_squared = displacement.squaredNorm();
  const double nearest = length_squared > 0 ? std::clamp(-apart.dot(displacement) / length_squared, 0.0, 1.0) : 0;
  return (apart + nearest * displacement).norm() <= a.shape.radius + b.shape.radius + gap;
}

/// Calls `use` with the touch of each pair of convex parts that meets.
template <class Use>
void for_each_touch(const Encounter& encounter, double ground_height, Use use) {
  if (!may_touch(encounter, ground_height)) return;
  const std::size_t b_parts = encounter.b.kind == Kind::ground ? 1 : encounter.b.shape.parts.size();
  for (std::size_t i = 0; i < encounter.a.shape.parts.size(); ++i)
    for (std::size_t j = 0; j < b_parts; ++j) {
      const auto touch = first_touch(placed(encounter.a, i, encounter.a_shift, ground_height), encounter.displacement,
                                     placed(encounter.b, j, encounter.b_shift, ground_height), encounter.gap);
      if (touch) use(*touch);
    }
}

Quat rotated(const Quat& rotation, const Vec3& turn) {
  const double angle = turn.norm();
  if (angle == 0) return rotation;
  return (Quat(Eigen::AngleAxisd(angle, turn / angle)) * rotation).normalized();
}

/// How two objects move on together for the rest of a substep: only spheres give way.
Vec3 common_velocity(const Object& sphere, const Object& met) {
  if (met.kind != Kind::sphere) return met.state.velocity;
  const double own = sphere.body->getInvMass(), other = met.body->getInvMass();
  return (other * sphere.state.velocity + own * met.state.velocity) / (own + other);
}

/// Fastest motion of a surface point due to rotation [m/s].
double turning_speed(const Object& object) { return object.state.angular_velocity.norm() * object.shape.radius; }

}  // namespace

void ContactWorld::Impl::move_spheres(double dt) {
  std::vector<std::size_t> spheres;
  for (std::size_t i = 0; i < objects.size(); ++i)
    if (objects[i].kind == Kind::sphere && objects[i].body) spheres.push_back(i);
  for (std::size_t i : spheres) {
    objects[i].state.pose.translation += objects[i].correction.translation;
    place(objects[i]);
  }
  std::vector<Vec3> paths;
  for (std::size_t i : spheres) paths.push_back(swept_path(i, dt));
  for (std::size_t i = 0; i < spheres.size(); ++i) {
    RigidState& state = objects[spheres[i]].state;
    state.pose.translation += paths[i];
    state.pose.rotation = rotated(state.pose.rotation, dt * state.angular_velocity);
    place(objects[spheres[i]]);
  }
}

/// The sphere's displacement over `dt` among the others in uniform motion. Slow touches let it slide on along the
/// surface; what it strikes takes it along for the rest of `dt`, so that the next detection finds both in touch.
Vec3 ContactWorld::Impl::swept_path(std::size_t sphere, double dt) const {
  const Object& moving = objects[sphere];
  Vec3 travelled = Vec3::Zero(), velocity = moving.state.velocity;
  double time = 0;
  for (int touches = 0; touches < kMaxTouches; ++touches) {
    const auto [touch, met] = next_touch(moving, travelled, velocity, time, dt);
    const double duration = touch.fraction * (dt - time);
    travelled += duration * velocity;
    time += duration;
    if (!met) break;
    const double approach = -touch.normal.dot(velocity - met->state.velocity);
    if (approach > kQuietSpeed) return travelled + (dt - time) * common_velocity(moving, *met);
    velocity += approach * touch.normal;
  }
  return travelled;
}

/// What a sphere in motion meets first between `time` and `dt`, `met` null for nothing.
ContactWorld::Impl::NextTouch ContactWorld::Impl::next_touch(const Object& moving, const Vec3& travelled,
                                                             const Vec3& velocity, double time, double dt) const {
  const double gap = -kTouchShare * moving.shape.radius;
  NextTouch next{{1, Vec3::Zero()}, nullptr};
  for (const Object& other : objects) {
    if (&other == &moving || !other.body) continue;
    const Vec3 displacement = (dt - time) * (velocity - other.state.velocity);
    const Encounter encounter{moving, other, travelled, time * other.state.velocity, displacement, gap};
    for_each_touch(encounter, ground_height, [&](const Touch& touch) {
      if (!next.met || touch.fraction < next.touch.fraction) next = {touch, &other};
    });
  }
  return next;
}

bool ContactWorld::Impl::would_strike(std::size_t first, std::size_t second, double dt, double minimum_speed) const {
  const Object &a = objects[first], &b = objects[second];
  const auto velocity = [&](const Object& object) {
    return object.moves() ? Vec3(object.state.velocity + dt * gravity) : object.state.velocity;
  };
  const Vec3 relative = velocity(a) - velocity(b);
  const double turning = turning_speed(a) + turning_speed(b);
  if (relative.norm() + turning <= minimum_speed) return false;
  bool strikes = false;
  const Encounter encounter{a, b, Vec3::Zero(), Vec3::Zero(), dt * relative, dt * turning};
  for_each_touch(encounter, ground_height,
                 [&](const Touch& touch) { strikes |= turning - touch.normal.dot(relative) > minimum_speed; });
  return strikes;
}

/// Sorts the swept extents along x and looks at those that overlap, where at least one object is fast enough.
bool ContactWorld::Impl::impact_expected(double dt, double minimum_speed) const {
  struct Extent {
    std::size_t object;
    double minimum, maximum;
    bool fast;
  };
  std::vector<Extent> extents;
  for (std::size_t i = 0; i < objects.size(); ++i) {
    const Object& object = objects[i];
    if (!object.body) continue;
    if (object.kind == Kind::ground) {
      for (std::size_t j = 0; j < objects.size(); ++j)
        if (objects[j].moves() && would_strike(j, i, dt, minimum_speed)) return true;
      continue;
    }
    const double speed = (object.state.velocity + dt * gravity).norm() + turning_speed(object);
    const double reach = object.shape.radius + dt * speed, x = object.state.pose.translation.x();
    extents.push_back({i, x - reach, x + reach, speed > minimum_speed / 2});
  }
  std::stable_sort(extents.begin(), extents.end(),
                   [](auto& left, auto& right) { return left.minimum < right.minimum; });
  for (auto a = extents.begin(); a != extents.end(); ++a)
    for (auto b = a + 1; b != extents.end() && b->minimum <= a->maximum; ++b) {
      if (!a->fast && !b->fast) continue;
      if (!objects[a->object].moves() && !objects[b->object].moves()) continue;
      if (would_strike(a->object, b->object, dt, minimum_speed)) return true;
    }
  return false;
}

}  // namespace griffith
