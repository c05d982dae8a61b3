#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

#include "sim/contact/bullet/contact_world.h"
#include "sim/contact/bullet/sweep.h"
#include "sim/core/parallel.h"
#include "sim/core/rotation.h"

namespace griffith {

using namespace contact;

namespace {

/// Time and place of the first touch of two convex parts.
struct Meeting {
  double time = 0;  ///< [s]
  Separation apart = {};
};

/// Object in free flight.
struct Flight : Course {
  const Object& object;

  Pose pose_after(double time) const {
    const Pose& start = object.state.pose;
    return {start.translation + displacement_after(time), Quat(rotation_by(time * spin)) * start.rotation};
  }
  Vec3 displacement_after(double time) const { return time * velocity_after(time); }
  Vec3 velocity_after(double time) const { return velocity + time * acceleration; }
  /// Returns the largest speed of a point along a unit vector by rotation [m/s].
  double turning_speed(const Vec3& direction) const { return spin.cross(direction).norm() * object.shape.radius; }
  double turning_speed() const { return spin.norm() * object.shape.radius; }
};

/// Returns an upper bound of the speed of its points within `dt` [m/s].
double highest_speed(const Flight& flight, double dt) {
  return flight.velocity.norm() + dt * flight.acceleration.norm() + flight.turning_speed();
}

/// Speeds of an object that decide if it may take part in a damaging impact.
struct Flyer {
  double speed, impact_speed;  ///< upper bound of its points; least one that could damage it [m/s]
};

/// A convex part of an object in flight.
struct FlyingPart {
  const Flight& flight;
  std::size_t index;
  double ground_height;  ///< height of an object without parts: the ground [m]

  PlacedShape shape_after(double time) const {
    return placed(flight.object, index, to_bullet(flight.pose_after(time)), ground_height);
  }
  /// Returns the points that may hit first: its corners, or the touched point of a sphere.
  std::vector<Vec3> striking_points(double time, const Vec3& touched) const {
    if (flight.object.kind == Kind::ground) return {};
    if (flight.object.is_sphere()) return {touched};
    std::vector<Vec3> points;
    const Pose pose = flight.pose_after(time);
    for (const Vec3& corner : flight.object.shape.hull(index).corners) points.push_back(pose.to_world(corner));
    return points;
  }
};

/// Returns the time in which this speed and acceleration cover x = t (v + t a); empty if the motion reverses before.
std::optional<double> time_to_cover(double distance, double speed, double acceleration) {
  const double square = speed * speed + 4 * acceleration * distance;
  if (square < 0 || speed + std::sqrt(square) <= 0) return std::nullopt;
  return 2 * distance / (speed + std::sqrt(square));
}

/// Returns the first touch of two parts within `dt` [s], if any. Conservative advancement (Mirtich 1996): no point can
/// cross the plane between them before an advance. It ends when the next advance would be shorter than `tolerance` [s].
std::optional<Meeting> first_meeting(const FlyingPart& part_of_a, const FlyingPart& part_of_b, double dt,
                                     double tolerance) {
  constexpr int kMaxAdvances = 64;
  const Flight &a = part_of_a.flight, &b = part_of_b.flight;
  Meeting meeting;
  for (int i = 0; i < kMaxAdvances; ++i) {
    meeting.apart = separation(part_of_a.shape_after(meeting.time), part_of_b.shape_after(meeting.time));
    if (meeting.apart.distance <= 0) return meeting;
    const Vec3& normal = meeting.apart.normal;
    const double pull = -normal.dot(a.acceleration - b.acceleration);
    const double speed = a.turning_speed(normal) + b.turning_speed(normal) -
                         normal.dot(a.velocity_after(meeting.time) - b.velocity_after(meeting.time));
    const auto advance = time_to_cover(meeting.apart.distance, speed + meeting.time * pull, pull);
    if (!advance || meeting.time + *advance > dt) return std::nullopt;
    if (*advance < tolerance) return meeting;
    meeting.time += *advance;
  }
  return meeting;
}

/// Impact of corners of two parts on each other.
struct Strike {
  double speed = 0;                                        ///< the fastest [m/s]
  double delay = std::numeric_limits<double>::infinity();  ///< time from their meeting to the first impact that could
                                                           ///< cause damage [s]
};

/// Returns the impact of corners of two parts on each other within `dt` [s] after their meeting: of corners that cross
/// the plane between the two in the remaining time. Impacts slower than `damage_speed` [m/s] cause no damage.
Strike strike_of(const FlyingPart& part_of_a, const FlyingPart& part_of_b, const Meeting& meeting, double dt,
                 double damage_speed) {
  const Flight &a = part_of_a.flight, &b = part_of_b.flight;
  const auto& [distance, normal, point_on_b] = meeting.apart;
  const Vec3 point_on_a = point_on_b + distance * normal;
  const double left = dt - meeting.time,
               bend = 0.5 * left * left * (a.spin.norm() * a.turning_speed() + b.spin.norm() * b.turning_speed());
  Strike found;
  const auto velocity_at = [&](const Flight& flight, const Vec3& place) {
    const Vec3 arm = place - flight.object.state.pose.translation - flight.displacement_after(meeting.time);
    return Vec3(flight.velocity_after(dt) + flight.spin.cross(arm));
  };
  const auto strike = [&](const Vec3& place, double height) {
    const double speed = -normal.dot(velocity_at(a, place) - velocity_at(b, place));
    const double way = std::max(0.0, height - std::max(distance, 0.0) - bend);
    if (way > left * speed) return;
    found.speed = std::max(found.speed, speed);
    if (speed > damage_speed) found.delay = std::min(found.delay, way / speed);
  };
  for (const Vec3& place : part_of_a.striking_points(meeting.time, point_on_a))
    strike(place, normal.dot(place - point_on_b));
  for (const Vec3& place : part_of_b.striking_points(meeting.time, point_on_b))
    strike(place, normal.dot(point_on_a - place));
  return found;
}

}  // namespace

/// Returns the motion of an object without contacts. Spheres do not need rotation.
Course ContactWorld::Impl::course_of(const Object& object) const {
  return {object.state.velocity, object.moves() ? gravity : Vec3::Zero(),
          object.is_sphere() ? Vec3::Zero() : object.state.angular_velocity};
}

std::optional<ContactWorld::Encounter> ContactWorld::Impl::expected_impact(const std::array<int, 2>& pair,
                                                                           const std::array<Course, 2>& courses,
                                                                           double dt, const ImpactRule& rule) const {
  const Flight a{courses[0], objects[pair[0]]}, b{courses[1], objects[pair[1]]};
  const double damage_speed = std::max(rule.minimum_speed, std::min(a.object.impact_speed, b.object.impact_speed));
  const Vec3 relative = a.velocity_after(dt) - b.velocity_after(dt), pull = a.acceleration - b.acceleration;
  const double turning = a.turning_speed() + b.turning_speed();
  if (relative.norm() + dt * pull.norm() + turning <= damage_speed) return std::nullopt;
  const double bend = 0.25 * dt * dt * pull.norm();  // of their ways, off the straight
  if (!may_touch(a.object, a.object.state.pose.translation, dt * relative, b.object, bend, ground_height))
    return std::nullopt;
  std::optional<Encounter> impact;
  for (std::size_t i = 0; i < a.object.shape.parts.size(); ++i)
    for (std::size_t j = 0; j < b.object.part_count(); ++j) {
      const FlyingPart part_of_a{a, i, ground_height}, part_of_b{b, j, ground_height};
      const PlacedShape moving = part_of_a.shape_after(0), other = part_of_b.shape_after(0);
      if (other.convex && !boxes_meet(moving, dt * relative, other, dt * turning + bend)) continue;
      const auto meeting = first_meeting(part_of_a, part_of_b, dt, rule.tolerance);
      if (!meeting) continue;
      const Strike strike = strike_of(part_of_a, part_of_b, *meeting, dt, damage_speed);
      if (strike.speed <= damage_speed) continue;
      if (!impact) impact = {ProxyId(pair[0]), ProxyId(pair[1]), 0, dt, dt};
      const double time = std::max(0.0, meeting->time - rule.tolerance);
      impact->approach = std::max(impact->approach, strike.speed);
      impact->time = std::min(impact->time, time);
      impact->strike = std::min(impact->strike, std::max(time, meeting->time + strike.delay - rule.tolerance));
    }
  return impact;
}

double ContactWorld::Impl::first_overlap(const Pair& pair, const std::array<Course, 2>& courses, double from,
                                         double to) const {
  constexpr double kAccuracy = 1.0 / 1024;  // of the time between
  const Flight a{courses[0], objects[pair.a]}, b{courses[1], objects[pair.b]};
  const FlyingPart part_of_a{a, static_cast<std::size_t>(pair.part_a), ground_height},
      part_of_b{b, static_cast<std::size_t>(pair.part_b), ground_height};
  const double accuracy = kAccuracy * (to - from);
  while (to - from > accuracy) {
    const double middle = 0.5 * (from + to);
    const bool overlap = separation(part_of_a.shape_after(middle), part_of_b.shape_after(middle)).distance <= 0;
    (overlap ? to : from) = middle;
  }
  return from;
}

/// Examines pairs of a sufficient relative speed.
std::vector<ContactWorld::Encounter> ContactWorld::Impl::expected_impacts(double dt, const ImpactRule& rule,
                                                                          const PairFilter& matters) const {
  std::vector<Flyer> flyers;
  double fastest = 0, weakest = std::numeric_limits<double>::infinity();
  for (const Object& object : objects) {
    const bool flies = object.exists && object.kind != Kind::ground && (object.moves() || !object.state.is_still());
    const double speed = flies ? highest_speed({course_of(object), object}, dt) : 0;
    flyers.push_back({speed, object.impact_speed});
    fastest = std::max(fastest, speed);
    if (object.exists) weakest = std::min(weakest, object.impact_speed);
  }
  if (2 * fastest <= std::max(rule.minimum_speed, weakest)) return {};
  std::vector<std::array<int, 2>> near;
  for_each_near(dt, [&](int first, int second) {
    const Flyer &a = flyers[first], &b = flyers[second];
    const double damage_speed = std::max(rule.minimum_speed, std::min(a.impact_speed, b.impact_speed));
    if (a.speed + b.speed > damage_speed) near.push_back({first, second});
  });
  std::ranges::sort(near);
  near.erase(std::unique(near.begin(), near.end()), near.end());
  std::erase_if(near, [&](std::array<int, 2>& pair) {
    if (pair[0] == ground) std::swap(pair[0], pair[1]);
    return matters && !matters(ProxyId(pair[0]), ProxyId(pair[1]));
  });
  std::vector<std::optional<Encounter>> met(near.size());
  parallel_for(static_cast<int>(near.size()), 16, [&](int begin, int end) {
    for (int i = begin; i < end; ++i)
      met[i] = expected_impact(near[i], {course_of(objects[near[i][0]]), course_of(objects[near[i][1]])}, dt, rule);
  });
  std::vector<Encounter> found;
  for (const std::optional<Encounter>& impact : met)
    if (impact) found.push_back(*impact);
  return found;
}

}  // namespace griffith
