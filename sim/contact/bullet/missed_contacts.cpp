#include <Eigen/Geometry>
#include <algorithm>

#include "sim/contact/bullet/contact_world.h"
#include "sim/core/rotation.h"

namespace griffith {

using namespace contact;

/// Motion of an object by its impulses in a substep.
struct ContactWorld::Impl::EndOfStep {
  Vec3 velocity, spin;    ///< after the impulses [m/s], [rad/s]
  Pose pose;              ///< at the end of the substep
  Place place;            ///< the same
  bool diverted = false;  ///< true if impulses take it to where detection did not expect it

  Vec3 velocity_at(const Vec3& arm) const { return velocity + spin.cross(arm); }
};

std::vector<ContactWorld::Impl::EndOfStep> ContactWorld::Impl::ends_of_step(double dt) const {
  const std::vector<Momentum> sums = impulse_sums();
  std::vector<EndOfStep> ends;
  ends.reserve(objects.size());
  for (std::size_t i = 0; i < objects.size(); ++i) {
    const Object& object = objects[i];
    const RigidState& state = object.state;
    EndOfStep& end = ends.emplace_back(EndOfStep{state.velocity, state.angular_velocity, state.pose, object.place});
    if (!object.moves() || object.kind == Kind::projectile) continue;
    const Mat3& turn = object.place.rotation;
    const Vec3 push = object.inverse_mass * sums[i].linear,
               spin = turn * (object.inverse_inertia * (turn.transpose() * sums[i].angular));
    end.velocity += push;
    end.spin += spin;
    end.pose.translation += dt * end.velocity;
    end.pose.rotation = (Quat(rotation_by(dt * end.spin)) * state.pose.rotation).normalized();
    end.place = {end.pose.rotation.toRotationMatrix(), end.pose.translation};
    const double radius = object.shape.radius, noticed = kContactReach * radius / dt;
    end.diverted =
        push.norm() + radius * spin.norm() > noticed && end.velocity.norm() + radius * end.spin.norm() > noticed;
  }
  return ends;
}

/// Returns the pairs of parts, at least one of a diverted object, that may overlap at the end of the substep.
std::vector<Pair> ContactWorld::Impl::pairs_at_end(const std::vector<EndOfStep>& ends) const {
  std::vector<Pair> near;
  const auto add = [&](int one, int part_of_one, int other, int part_of_other) {
    near.push_back(one < other ? Pair{one, other, part_of_one, part_of_other, -1}
                               : Pair{other, one, part_of_other, part_of_one, -1});
  };
  const auto part_box = [&](int i, std::size_t part) {
    const Object& object = objects[i];
    const Vec3 room = Vec3::Constant(object.shape.radius);
    if (object.is_sphere()) return Box{ends[i].pose.translation - room, ends[i].pose.translation + room};
    const Hull& hull = object.shape.hull(part);
    const Vec3 center = ends[i].place.to_world(hull.box_center),
               half = ends[i].place.rotation.cwiseAbs() * hull.box_half;
    return Box{center - half, center + half};
  };
  const auto meet = [&](int one, int other, double room) {
    return (ends[one].pose.translation - ends[other].pose.translation).norm() <
           objects[one].shape.radius + objects[other].shape.radius + room;
  };
  for (int i = 0; i < static_cast<int>(objects.size()); ++i) {
    if (!ends[i].diverted) continue;
    for (std::size_t part = 0; part < objects[i].part_count(); ++part) {
      const Box box = part_box(i, part);
      if (ground >= 0 && box.low.y() < ground_height) add(i, static_cast<int>(part), ground, 0);
      tree.for_each(box, [&](const BoxTree::Item& item) {
        const Object& other = objects[item.object];
        if (item.object != i && other.exists && other.kind != Kind::projectile && may_meet(objects[i], other) &&
            meet(i, item.object, 0) && part_box(item.object, item.part).meets(box))
          add(i, static_cast<int>(part), item.object, item.part);
      });
    }
  }
  std::ranges::sort(near, std::ranges::less(), &Pair::key);
  const auto same = [](const Pair& left, const Pair& right) { return left.key() == right.key(); };
  near.erase(std::unique(near.begin(), near.end(), same), near.end());
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

/// Adds the points at which two parts that are apart now overlap at the end of the substep.
void ContactWorld::Impl::add_missed(const Pair& pair, const std::vector<EndOfStep>& ends, double dt,
                                    std::vector<Contact>& missed) const {
  const EndOfStep &a = ends[pair.a], &b = ends[pair.b];
  const double tolerance = kContactReach * smaller_radius(objects[pair.a], objects[pair.b]);
  Manifold manifold;
  find_points(pair, manifold, {a.pose, a.place}, {b.pose, b.place}, -tolerance);
  for (const Manifold::Point& point : manifold.listed()) {
    if (contact_at(pair, manifold, point, a.place, b.place).distance > -tolerance) continue;
    const Contact now = contact_at(pair, manifold, point, objects[pair.a].place, objects[pair.b].place);
    const Vec3 arm_a = now.position - objects[pair.a].place.translation,
               arm_b = now.position - objects[pair.b].place.translation;
    const double speed = -now.normal.dot(a.velocity_at(arm_a) - b.velocity_at(arm_b));
    if (now.distance > 0 && now.distance < dt * speed && !is_listed(now)) missed.push_back(now);
  }
}

std::vector<Contact> ContactWorld::Impl::missed_contacts(double dt, const std::vector<bool>& left_out) const {
  std::vector<Contact> missed;
  if (contacts.empty()) return missed;
  const std::vector<EndOfStep> ends = ends_of_step(dt);
  if (std::ranges::none_of(ends, &EndOfStep::diverted)) return missed;
  const auto is_left_out = [&](int object) {
    return static_cast<std::size_t>(object) < left_out.size() && left_out[object];
  };
  for (const Pair& pair : pairs_at_end(ends))
    if (!is_left_out(pair.a) && !is_left_out(pair.b)) add_missed(pair, ends, dt, missed);
  return missed;
}

}  // namespace griffith
