#include "sim/world/contact/group_builder.h"

#include <algorithm>
#include <iterator>
#include <utility>

#include "sim/solver/contact_cone.h"
#include "sim/solver/pivot.h"
#include "sim/world/bodies/bodies.h"
#include "sim/world/bodies/effective_law.h"
#include "sim/world/bodies/supported_motion.h"
#include "sim/world/contact/bond_rows.h"
#include "sim/world/motion/elastic_phase.h"

namespace griffith {

DeformableInertia deformable_inertia(const WorldState& world, const Body& body, double dt, bool factors_with_contacts) {
  DeformableInertia inertia;
  inertia.whole = whole_motion(world, body, dt);
  constexpr int kFewRows = 2000;
  inertia.factors_with_contacts = factors_with_contacts && body.system->rows() < kFewRows;
  if (!world.integrates_explicitly()) {
    inertia.matrix = &body.system->matrix();
    inertia.preconditioner = &body.system->preconditioner();
    inertia.factors = body.system->factors();
    return inertia;
  }
  inertia.masses = body.system->gather_masses(world.nodes.masses, world.edges.masses);
  return inertia;
}

namespace {

/// True if an impulse along a unit normal moves a side of a contact.
bool can_move(const ContactSide& side, const Vec3& normal) {
  constexpr double kNegligible = 1e-3;  // of the motion of a free node: rounding errors beside a held one
  if (!side.deformable) return side.body >= 0;
  double motion = 0;
  for (int i = 0; i < 3; ++i)
    if (side.point.rows[i] >= 0) motion += normal.dot(side.point.weights[i] * normal);
  return motion > kNegligible;
}

/// Builds the problems of all groups.
class GroupBuilder {
 public:
  GroupBuilder(const WorldState& world, const TouchedBodies& touched, double dt)
      : world_(world),
        touched_(touched),
        dt_(dt),
        body_of_object_(world.body_of_proxy.size() + world.projectiles.size() + 1, -1),
        soft_(touched.bodies.size(), false),
        held_(touched.bodies.size(), false) {
    for (std::size_t i = 0; i < touched.objects.size(); ++i) {
      if (world.bodies[touched.bodies[i].body].quasi_static) continue;
      const ElasticObject& object = touched.objects[i];
      grow(object.object);
      touched_of(object.object) = static_cast<int>(i);
      const Body& body = world.bodies[touched.bodies[i].body];
      soft_[i] = sags_visibly(world, body);
      held_[i] = body.supported();
      for (std::size_t k = 0; k < object.contacts.size(); ++k)
        points_.push_back({object.contacts[k], static_cast<int>(i), static_cast<int>(k)});
    }
    std::ranges::sort(points_, {}, [](const Point& point) { return std::pair(point.contact, point.touched); });
  }

  ContactGroup build(const std::vector<int>& contacts) {
    ContactGroup group;
    double fastest = 0;
    for (const int contact : contacts) fastest = std::max(fastest, speed_to_stop(contact));
    for (const int contact : contacts) {
      const Contact& found = std::as_const(world_.contact_world).contacts()[contact];
      const ContactWorld::Law law = world_.contact_world.law(contact);
      FrictionContact row;
      row.a = side(group, found.a, contact, law.arm_a);
      row.b = side(group, found.b, contact, law.arm_b);
      if (!can_move(row.a, found.normal) && !can_move(row.b, found.normal)) continue;
      row.axes = law.axes;
      row.friction = law.friction;
      row.target_velocity = target_velocity(found, contact, std::min(0.0, law.target_velocity), fastest);
      row.rebound = law.target_velocity > 0 && is_impact(found, contact) ? law.target_velocity : 0;
      group.target_velocities.push_back(row.target_velocity);
      row.free_velocity = law.axes.transpose() * law.free_velocity;
      row.impulse = law.guess;
      group.problem.push_back(row);
      group.contacts.push_back(contact);
    }
    for (const int touched : group.touched) add_bonds(touched, group);
    return group;
  }

  /// Returns groups of single bodies with bonds that nothing touches.
  std::vector<ContactGroup> build_bonded() {
    std::vector<ContactGroup> groups;
    for (std::size_t i = 0; i < touched_.bodies.size(); ++i) {
      const TouchedBody& of = touched_.bodies[i];
      const bool is_bonded = !of.bonds.pairs.empty() || !of.bonds.ties.empty();
      if (!is_bonded || body_of_object_[touched_.objects[i].object.index()] >= 0) continue;
      ContactGroup& group = groups.emplace_back();
      add_deformable(group, touched_.objects[i].object);
      add_bonds(static_cast<int>(i), group);
    }
    return groups;
  }

 private:
  /// Contact of an elastic body, and its place in its list.
  struct Point {
    int contact, touched, index;
  };

  void grow(ProxyId object) {
    const auto index = static_cast<std::size_t>(object.index());
    if (index >= body_of_object_.size()) body_of_object_.resize(index + 1, -1);
    if (index >= touched_of_object_.size()) touched_of_object_.resize(index + 1, -1);
  }
  int& touched_of(ProxyId object) { return touched_of_object_[object.index()]; }

  bool is_deformable(ProxyId object) {
    grow(object);
    return touched_of(object) >= 0;
  }

  /// Returns the point of a deformable object at a contact.
  const TouchedPoint& point_at(ProxyId object, int contact) {
    const int touched = touched_of(object);
    const auto point = std::ranges::lower_bound(points_, std::pair(contact, touched), {},
                                                [](const Point& p) { return std::pair(p.contact, p.touched); });
    return touched_.bodies[touched].points[point->index];
  }

  bool is_marked(const std::vector<bool>& marks, ProxyId object) {
    return is_deformable(object) && marks[touched_of(object)];
  }

  /// Returns the speed that a contact has to stop, along the normal or, if it stuck, along the surface [m/s].
  double speed_to_stop(int contact) const {
    const ContactWorld::Law law = world_.contact_world.law(contact);
    const Vec3 velocity = law.axes.transpose() * law.free_velocity;
    return std::max(-velocity[0], sticks(law.guess, law.friction) ? velocity.tail<2>().norm() : 0);
  }

  bool strains_far(ProxyId object) {
    return is_deformable(object) && can_be_compacted(world_, world_.bodies[world_.body_of(object)]);
  }

  /// Returns the velocity of an object at a contact when the substep began [m/s].
  Vec3 first_velocity(ProxyId object, int contact, const Vec3& position) {
    const SubstepStart& start = world_.scratch.substep_start;
    if (is_deformable(object)) return point_at(object, contact).surface.interpolate(start.velocities);
    const BodyId id = world_.body_of(object);
    if (!id.valid() || world_.bodies[id].supported()) {
      const RigidState state = world_.contact_world.state(object);
      return state.velocity + state.angular_velocity.cross(position - state.pose.translation);
    }
    const RigidStart& of_body = world_.scratch.bodies[id].start;
    return of_body.velocity + of_body.angular_velocity.cross(position - world_.bodies[id].motion.center);
  }

  /// Returns the speed at which the sides of a contact approached when the substep began [m/s].
  double first_approach(const Contact& contact, int index) {
    return contact.normal.dot(first_velocity(contact.b, index, contact.position) -
                              first_velocity(contact.a, index, contact.position));
  }

  /// True if a gap closes in the substep by the velocities at its start, not because a bent body springs back as soon
  /// as what carries it is left out. Bodies that may strain far spring back as they are thrown.
  bool closes_by_motion(const Contact& contact, int index) {
    if (strains_far(contact.a) || strains_far(contact.b)) return true;
    return dt_ * first_approach(contact, index) > contact.distance;
  }

  /// True if the sides of a contact meet by the velocities at the start of the substep, not because a strained body
  /// springs back as soon as what presses on it is left out.
  bool is_impact(const Contact& contact, int index) {
    if (!is_deformable(contact.a) && !is_deformable(contact.b)) return true;
    return first_approach(contact, index) > 0.5 * contact.approach;
  }

  /// Returns the least separation velocity [m/s]. A soft body closes its gap within the substep: stopped at once, like
  /// a hard one, it would stay in the air by its speed times the step. Out of the ground, soft and held bodies, which
  /// nothing else moves out, go as slowly as the tolerance of impulses let them in, so they receive no more energy than
  /// they lost there.
  double target_velocity(const Contact& contact, int index, double of_law, double fastest) {
    constexpr double kTolerance = 1e-3;  // of the group's fastest: ten times that of its impulses
    const bool soft = is_marked(soft_, contact.a) || is_marked(soft_, contact.b);
    if (contact.distance > 0 && (soft || !closes_by_motion(contact, index))) return -contact.distance / dt_;
    const bool is_on_ground = world_.contact_world.is_ground(contact.a) || world_.contact_world.is_ground(contact.b);
    const bool held = is_marked(held_, contact.a) || is_marked(held_, contact.b);
    if ((soft || held) && is_on_ground && contact.distance < 0)
      return std::min(-contact.distance / dt_, kTolerance * fastest);
    return soft ? 0 : of_law;
  }

  ContactSide side(ContactGroup& group, ProxyId object, int contact, const Vec3& arm) {
    if (is_deformable(object)) return deformable_side(group, object, contact);
    const std::optional<RigidMass> mass = world_.contact_world.rigid_mass(object);
    if (!mass) return {};
    int& body = body_of_object_[object.index()];
    if (body < 0) {
      body = static_cast<int>(group.rigid.size());
      group.rigid.push_back({mass->mass, mass->inertia});
    }
    ContactSide rigid;
    rigid.body = body;
    rigid.arm = arm;
    return rigid;
  }

  /// Returns the index of a deformable body in its group, to which it is added first if it is not in it.
  int add_deformable(ContactGroup& group, ProxyId object) {
    int& body = body_of_object_[object.index()];
    if (body >= 0) return body;
    body = static_cast<int>(group.deformable.size());
    const int touched = touched_of(object);
    group.deformable.push_back(deformable_inertia(world_, world_.bodies[touched_.bodies[touched].body], dt_));
    group.touched.push_back(touched);
    return body;
  }

  void add_bonds(int touched, ContactGroup& group) const {
    const int body = body_of_object_[touched_.objects[touched].object.index()];
    add_bond_rows(world_, touched_.bodies[touched], body, dt_, group);
  }

  ContactSide deformable_side(ContactGroup& group, ProxyId object, int contact) {
    const int touched = touched_of(object);
    const int body = add_deformable(group, object);
    const TouchedPoint& point = point_at(object, contact);
    ContactSide side;
    side.body = body;
    side.deformable = true;
    side.point = weighted_rows(world_, point.surface);
    if (!world_.bodies[touched_.bodies[touched].body].supported()) side.offset = point.contact - point.position;
    return side;
  }

  const WorldState& world_;
  const TouchedBodies& touched_;
  double dt_;
  std::vector<int> body_of_object_;     // index in its group, -1 before
  std::vector<int> touched_of_object_;  // index into the touched bodies, -1 for what is not elastic
  std::vector<bool> soft_, held_;       // per touched body: visibly strained by its own weight; held by supports
  std::vector<Point> points_;
};

}  // namespace

std::vector<ContactGroup> build_contact_groups(const WorldState& world, const TouchedBodies& touched, double dt) {
  std::vector<ContactGroup> groups;
  GroupBuilder builder(world, touched, dt);
  for (const std::vector<int>& contacts : world.contact_world.elastic_groups())
    groups.push_back(builder.build(contacts));
  std::ranges::move(builder.build_bonded(), std::back_inserter(groups));
  return groups;
}

WholeMotion whole_motion(const WorldState& world, const Body& body, double dt) {
  const std::optional<Pivot> pivot = pivot_of(world, body);
  if (body.supported() && !pivot) return {};
  const std::span<const NodeId> nodes = body.system->nodes();
  Eigen::VectorXd masses(static_cast<Eigen::Index>(nodes.size()));
  for (std::size_t row = 0; row < nodes.size(); ++row) masses[row] = world.nodes.masses[nodes[row]];
  NodeVectors places = body.system->gather(world.nodes.positions, world.edges.offsets);
  WholeMotion whole = pivot ? swinging_motion(std::move(places), std::move(masses), *pivot)
                            : free_motion(std::move(places), std::move(masses));
  whole.damping = 1 + dt * world.material_of(body).mass_damping;
  return whole;
}

}  // namespace griffith
