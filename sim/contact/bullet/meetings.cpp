#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <utility>

#include "sim/contact/bullet/contact_world.h"
#include "sim/core/rotation.h"

namespace griffith {

using namespace contact;

/// Motion of an object by its impulses in a substep.
struct ContactWorld::Impl::EndOfStep {
  RigidState state;              ///< pose at the end of the substep, velocities after the impulses
  Place place;                   ///< the same place
  Mat3 turn = Mat3::Identity();  ///< by which it turns
  bool is_owners = false;        ///< true if its group is left to the owner
  bool matters = false;          ///< true if it may come to points that are not listed
};

namespace {

/// Overlaps that are worth solving everything again, as a fraction of the smaller thickness: of rigid objects, and of
/// those whose owner has the dearer problem to solve.
constexpr double kNoticed = 0.03, kDeep = 0.2;

/// Overlap with which an object is no longer where it should be, as a fraction of the smaller thickness.
constexpr double kThrough = 0.5;

/// True for the same two parts, in either order.
bool are_same(const Pair& left, const Pair& right) { return left.key() == right.key(); }

Pair ordered_pair(int one, int part_of_one, int other, int part_of_other) {
  return one < other ? Pair{one, other, part_of_one, part_of_other, -1}
                     : Pair{other, one, part_of_other, part_of_one, -1};
}

/// Returns the box of a part of an object at a place.
Box box_at(const Object& object, int part, const Place& place) {
  const Vec3 radius = Vec3::Constant(object.shape.radius);
  if (object.is_sphere()) return {place.translation - radius, place.translation + radius};
  const Hull& hull = object.shape.hull(part);
  const Vec3 center = place.to_world(hull.box_center), half = place.rotation.cwiseAbs() * hull.box_half;
  return {center - half, center + half};
}

/// Returns the mean of a point's place while its object turns by `turn`, relative to the object's center, from where
/// the center starts.
Vec3 mean_place(const Object& object, const Mat3& turn, const Vec3& point) {
  constexpr double kSmall = 1e-6;  // [rad]
  const Eigen::AngleAxisd rotation(turn);
  const double angle = rotation.angle();
  const Vec3 arm = object.place.rotation * point;
  if (angle < kSmall) return object.place.translation + arm;
  const Vec3 along = rotation.axis().dot(arm) * rotation.axis(), across = arm - along;
  return object.place.translation + along +
         (std::sin(angle) * across + (1 - std::cos(angle)) * rotation.axis().cross(arm)) / angle;
}

/// Returns the velocity of an object at a position, for these velocities of its own [m/s].
Vec3 velocity_at(const Object& object, const RigidState& velocities, const Vec3& position) {
  return velocities.velocity + velocities.angular_velocity.cross(position - object.place.translation);
}

}  // namespace

ContactWorld::Impl::EndOfStep ContactWorld::Impl::end_of_step(std::size_t index, const Momentum& impulses,
                                                              double dt) const {
  const Object& object = objects[index];
  EndOfStep end{object.state, object.place};
  if (!object.moves() || object.kind == Kind::projectile) return end;
  const Mat3& turn = object.place.rotation;
  const Vec3 push = object.inverse_mass * impulses.linear,
             spin = turn * (object.inverse_inertia * (turn.transpose() * impulses.angular));
  RigidState& state = end.state;
  state.velocity += push;
  state.angular_velocity += spin;
  state.pose.translation += dt * state.velocity;
  end.turn = free_turn(world_inertia(object), state.angular_velocity, dt);
  end.place = {end.turn * turn, state.pose.translation};
  state.pose.rotation = (Quat(end.turn) * state.pose.rotation).normalized();
  const double radius = object.shape.radius, angle = dt * state.angular_velocity.norm();
  const double visible = kNoticed * radius;
  // Before the contacts are solved all that rests is about to fall; then also what gravity has turned back counts.
  const Vec3 changed = scratch.is_solved ? Vec3(state.velocity - object.first_velocity) : push;
  const bool is_diverted = dt * (changed.norm() + radius * spin.norm()) > visible &&
                           dt * state.velocity.norm() + radius * angle > visible,
             turns_far = 0.5 * angle * angle * radius > visible;
  end.matters = is_diverted || turns_far || scratch.unlisted[index];
  return end;
}

std::vector<ContactWorld::Impl::EndOfStep> ContactWorld::Impl::ends_of_step(double dt) const {
  const std::vector<Momentum> sums = impulse_sums();
  std::vector<EndOfStep> ends;
  ends.reserve(objects.size());
  for (std::size_t i = 0; i < objects.size(); ++i) ends.push_back(end_of_step(i, sums[i], dt));
  for (const int contact : elastic_contacts)
    for (const ProxyId side : {contacts[contact].a, contacts[contact].b})
      ends[side.index()].is_owners = objects[side].moves();
  return ends;
}

/// Returns the pairs of parts, at least one of an object that matters, that may overlap at the end of the substep.
std::vector<Pair> ContactWorld::Impl::pairs_at_end(const std::vector<EndOfStep>& ends) const {
  std::vector<Pair> near;
  const auto spheres_meet_at_end = [&](int one, int other) {
    return (ends[one].place.translation - ends[other].place.translation).norm() <
           objects[one].shape.radius + objects[other].shape.radius;
  };
  for (int i = 0; i < static_cast<int>(objects.size()); ++i) {
    if (!ends[i].matters) continue;
    for (int part = 0; part < static_cast<int>(objects[i].part_count()); ++part) {
      const Box box = box_at(objects[i], part, ends[i].place);
      if (ground >= 0 && box.low.y() < ground_height) near.push_back(ordered_pair(i, part, ground, 0));
      tree.for_each(box, [&](const BoxTree::Item& item) {
        const Object& other = objects[item.object];
        if (item.object != i && other.exists && other.kind != Kind::projectile && spheres_meet_at_end(i, item.object) &&
            box_at(other, item.part, ends[item.object].place).meets(box))
          near.push_back(ordered_pair(i, part, item.object, item.part));
      });
    }
  }
  std::ranges::sort(near, std::ranges::less(), &Pair::key);
  near.erase(std::unique(near.begin(), near.end(), are_same), near.end());
  return near;
}

/// True if a contact of the same two objects is listed near a place.
bool ContactWorld::Impl::is_listed(const Contact& contact) const {
  constexpr double kNear = 0.1;  // of the smaller radius
  const double near = kNear * smaller_radius(objects[contact.a], objects[contact.b]);
  return std::ranges::any_of(contacts, [&](const Contact& other) {
    const bool same = (other.a == contact.a && other.b == contact.b) || (other.a == contact.b && other.b == contact.a);
    return same && (other.position - contact.position).norm() < near;
  });
}

/// Returns the points at which two parts that are apart now overlap at the end of the substep. Their position is the
/// mean over the substep, at which velocities give the displacement of points that turn far.
ContactWorld::Impl::UnlistedPoints ContactWorld::Impl::unlisted_points(const Pair& pair,
                                                                       const std::vector<EndOfStep>& ends,
                                                                       double dt) const {
  const Object &a = objects[pair.a], &b = objects[pair.b];
  const EndOfStep &end_of_a = ends[pair.a], &end_of_b = ends[pair.b];
  const double tolerance = (end_of_a.is_owners || end_of_b.is_owners ? kDeep : kNoticed) * smaller_thickness(a, b);
  Manifold manifold;
  find_points(pair, manifold, {end_of_a.state.pose, end_of_a.place}, {end_of_b.state.pose, end_of_b.place}, -tolerance);
  UnlistedPoints found;
  for (const Manifold::Point& point : manifold.listed()) {
    Contact contact = contact_at(pair, manifold, point, end_of_a.place, end_of_b.place);
    contact.position_at = PositionTime::mean;
    if (contact.distance > -tolerance) continue;
    const double turn_of_a = end_of_a.state.angular_velocity.norm(), turn_of_b = end_of_b.state.angular_velocity.norm();
    const double share = turn_of_a + turn_of_b > 0 ? turn_of_a / (turn_of_a + turn_of_b) : 0.5;
    contact.position =
        share * mean_place(a, end_of_a.turn, point.on_a) + (1 - share) * mean_place(b, end_of_b.turn, point.on_b);
    const Vec3 parting =
        velocity_at(a, end_of_a.state, contact.position) - velocity_at(b, end_of_b.state, contact.position);
    const double overlap = -std::exchange(contact.distance, contact.distance - dt * contact.normal.dot(parting));
    if (contact.distance <= 0 || is_listed(contact)) continue;
    found.points.push_back(contact);
    found.is_deep |= overlap > kThrough * smaller_thickness(a, b);
  }
  return found;
}

/// Returns the meeting of two objects, without points.
ContactWorld::Meeting ContactWorld::Impl::meeting_of(const Pair& pair, const std::vector<EndOfStep>& ends, double dt,
                                                     const ImpactRule& rule) const {
  const Pair of_impact = pair.a == ground ? Pair{pair.b, pair.a, pair.part_b, pair.part_a, -1} : pair;
  const std::array<int, 2> order{of_impact.a, of_impact.b};
  Meeting meeting;
  std::array<Course, 2> courses;
  for (int i = 0; i < 2; ++i) {
    const Object& object = objects[order[i]];
    const RigidState& end = ends[order[i]].state;
    meeting.objects[i] = ProxyId(order[i]);
    meeting.starts[i] = {object.state.pose, end.velocity, end.angular_velocity};
    courses[i] = {end.velocity, Vec3::Zero(), object.is_sphere() ? Vec3::Zero() : end.angular_velocity};
  }
  meeting.impact = expected_impact(order, courses, dt, rule);
  if (meeting.impact) meeting.impact->strike = first_overlap(of_impact, courses, meeting.impact->strike, dt);
  return meeting;
}

std::vector<ContactWorld::Meeting> ContactWorld::Impl::unlisted_meetings(double dt, const ImpactRule& rule,
                                                                         const std::vector<bool>& left_out) const {
  std::vector<Meeting> meetings;
  const std::vector<EndOfStep> ends = ends_of_step(dt);
  if (std::ranges::none_of(ends, &EndOfStep::matters)) return meetings;
  const auto is_left_out = [&](int object) {
    return static_cast<std::size_t>(object) < left_out.size() && left_out[object];
  };
  const Pair* last = nullptr;
  const std::vector<Pair> near = pairs_at_end(ends);
  for (const Pair& pair : near) {
    if (is_left_out(pair.a) || is_left_out(pair.b)) continue;
    const UnlistedPoints found = unlisted_points(pair, ends, dt);
    if (found.points.empty()) continue;
    if (!last || last->a != pair.a || last->b != pair.b) meetings.push_back(meeting_of(pair, ends, dt, rule));
    meetings.back().is_deep |= found.is_deep;
    meetings.back().points.insert(meetings.back().points.end(), found.points.begin(), found.points.end());
    last = &pair;
  }
  return meetings;
}

}  // namespace griffith
