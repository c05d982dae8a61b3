#include "sim/world/contact/elastic_contacts.h"

#include <algorithm>
#include <iterator>
#include <numeric>
#include <utility>

#include "sim/core/parallel.h"
#include "sim/solver/contact_cone.h"
#include "sim/solver/contact_problem.h"
#include "sim/solver/pivot.h"
#include "sim/world/bodies/bodies.h"
#include "sim/world/contact/bond_rows.h"
#include "sim/world/motion/elastic_phase.h"
#include "sim/world/state/world_state.h"

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

  ContactGroup build(std::vector<int> contacts) {
    ContactGroup group;
    double fastest = 0;
    for (const int contact : contacts) fastest = std::max(fastest, speed_to_stop(contact));
    for (const int contact : contacts) {
      const Contact& found = std::as_const(world_.contact_world).contacts()[contact];
      const ContactWorld::Law law = world_.contact_world.law(contact);
      FrictionContact& row = group.problem.emplace_back();
      row.a = side(group, found.a, contact, law.arm_a);
      row.b = side(group, found.b, contact, law.arm_b);
      row.axes = law.axes;
      row.friction = law.friction;
      row.target_velocity = target_velocity(found, std::min(0.0, law.target_velocity), fastest);
      row.rebound = std::max(0.0, law.target_velocity);
      group.target_velocities.push_back(row.target_velocity);
      row.free_velocity = law.axes.transpose() * law.free_velocity;
      row.impulse = law.guess;
    }
    group.contacts = std::move(contacts);
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

  bool is_marked(const std::vector<bool>& marks, ProxyId object) {
    grow(object);
    return touched_of(object) >= 0 && marks[touched_of(object)];
  }

  /// Returns the speed that a contact has to stop, along the normal or, if it stuck, along the surface [m/s].
  double speed_to_stop(int contact) const {
    const ContactWorld::Law law = world_.contact_world.law(contact);
    const Vec3 velocity = law.axes.transpose() * law.free_velocity;
    return std::max(-velocity[0], sticks(law.guess, law.friction) ? velocity.tail<2>().norm() : 0);
  }

  /// Returns the least separation velocity [m/s]. A soft body closes its gap within the substep: stopped at once, like
  /// a hard one, it would stay in the air by its speed times the step. Out of the ground, soft and held bodies, which
  /// nothing else moves out, go as slowly as the tolerance of impulses let them in, so they receive no more energy than
  /// they lost there.
  double target_velocity(const Contact& contact, double of_law, double fastest) {
    constexpr double kTolerance = 1e-3;  // of the group's fastest: ten times that of its impulses
    const bool soft = is_marked(soft_, contact.a) || is_marked(soft_, contact.b);
    if (soft && contact.distance > 0) return -contact.distance / dt_;
    const bool is_on_ground = world_.contact_world.is_ground(contact.a) || world_.contact_world.is_ground(contact.b);
    const bool held = is_marked(held_, contact.a) || is_marked(held_, contact.b);
    if ((soft || held) && is_on_ground && contact.distance < 0)
      return std::min(-contact.distance / dt_, kTolerance * fastest);
    return soft ? 0 : of_law;
  }

  ContactSide side(ContactGroup& group, ProxyId object, int contact, const Vec3& arm) {
    grow(object);
    if (touched_of(object) >= 0) return deformable_side(group, object, contact);
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
    const auto point = std::ranges::lower_bound(points_, std::pair(contact, touched), {},
                                                [](const Point& p) { return std::pair(p.contact, p.touched); });
    ContactSide side;
    side.body = body;
    side.deformable = true;
    const TouchedBody& of = touched_.bodies[touched];
    side.point = weighted_rows(world_, of.points[point->index].surface);
    if (!world_.bodies[of.body].supported())
      side.offset = of.points[point->index].contact - of.points[point->index].position;
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

ContactTolerance tolerance_of(const WorldState& world, double dt) {
  constexpr double kNegligible = 1e-6;  // of what gravity adds in a substep
  ContactTolerance tolerance;
  tolerance.relative = std::min(1e-4, world.model->scene.simulation.relative_residual);
  tolerance.negligible_speed = std::max(1e-12, kNegligible * dt * world.model->scene.gravity.norm());
  tolerance.max_iterations = world.model->scene.simulation.max_solver_iterations;
  return tolerance;
}

}  // namespace

namespace {

NodeVectors columns_of(std::span<const NodeId> nodes, const std::vector<Vec3>& values) {
  NodeVectors columns(3, static_cast<Eigen::Index>(nodes.size()));
  for (std::size_t i = 0; i < nodes.size(); ++i) columns.col(static_cast<Eigen::Index>(i)) = values[nodes[i]];
  return columns;
}

/// Returns quasi-static bodies that can rotate about a hinge or a joint of their supports.
std::vector<HingedObject> hinged_objects(const WorldState& world, const TouchedBodies& touched, double dt) {
  std::vector<HingedObject> hinged;
  for (std::size_t i = 0; i < touched.bodies.size(); ++i) {
    const Body& body = world.bodies[touched.bodies[i].body];
    if (!body.quasi_static || !body.supported()) continue;
    const auto pivot = pivot_of(world, body);
    if (!pivot) continue;
    const std::span<const NodeId> nodes = body.system->nodes();
    Eigen::VectorXd masses(static_cast<Eigen::Index>(nodes.size()));
    for (std::size_t row = 0; row < nodes.size(); ++row) masses[row] = world.nodes.masses[nodes[row]];
    const auto spin_of = [&](const std::vector<Vec3>& velocities) {
      return turning_about(*pivot, columns_of(nodes, world.nodes.positions), columns_of(nodes, velocities), masses)
          .spin;
    };
    hinged.push_back({body.proxy, body.motion.mass, pivot->place, whole_motion(world, body, dt).inverse_inertia,
                      spin_of(world.scratch.substep_start.velocities), spin_of(world.nodes.velocities)});
  }
  return hinged;
}

/// Returns the coupled bodies, with their indices in `touched`.
std::vector<ElasticObject> coupled_objects(const WorldState& world, const TouchedBodies& touched) {
  std::vector<ElasticObject> coupled;
  for (std::size_t i = 0; i < touched.bodies.size(); ++i)
    if (!world.bodies[touched.bodies[i].body].quasi_static) coupled.push_back(touched.objects[i]);
  return coupled;
}

}  // namespace

namespace {

/// Calls visit(row of the group's problem, touched body, its point there, 1 as side a of the contact or −1 as side b).
template <class Visit>
void visit_points(const WorldState& world, const TouchedBodies& touched, const ContactGroup& group,
                  const Visit& visit) {
  for (const int i : group.touched)
    for (std::size_t k = 0; k < touched.objects[i].contacts.size(); ++k) {
      const int contact = touched.objects[i].contacts[k];
      const auto row = std::ranges::lower_bound(group.contacts, contact) - group.contacts.begin();
      const bool is_a = world.contact_world.contacts()[contact].a == touched.objects[i].object;
      visit(static_cast<std::size_t>(row), i, k, is_a ? 1.0 : -1.0);
    }
}

/// Takes into account where turning bodies get beside their velocities.
void foresee_turns(const WorldState& world, const TouchedBodies& touched, double dt, ContactGroup& group) {
  for (std::size_t row = 0; row < group.problem.size(); ++row)
    group.problem[row].target_velocity = group.target_velocities[row];
  visit_points(world, touched, group, [&](std::size_t row, int body, std::size_t point, double side) {
    const Vec3& turned = touched.bodies[body].points[point].turned;
    if (!turned.isZero(0)) group.problem[row].target_velocity -= side * group.problem[row].axes.col(0).dot(turned) / dt;
  });
}

/// Takes the present inertia of its bodies, and their velocities without contacts.
void renew(const WorldState& world, TouchedBodies& touched, double dt, ContactGroup& group) {
  for (std::size_t i = 0; i < group.touched.size(); ++i)
    group.deformable[i] = deformable_inertia(world, world.bodies[touched.bodies[group.touched[i]].body], dt, true);
  std::vector<Eigen::Matrix3Xd> faster(touched.bodies.size());
  for (const int i : group.touched) {
    Eigen::Matrix3Xd& before = touched.objects[i].free_velocities;
    const Eigen::Matrix3Xd now = point_velocities(world, touched.bodies[i]);
    faster[i] = now - before;
    before = now;
  }
  visit_points(world, touched, group, [&](std::size_t row, int body, std::size_t point, double side) {
    FrictionContact& contact = group.problem[row];
    contact.free_velocity += side * (contact.axes.transpose() * faster[body].col(static_cast<Eigen::Index>(point)));
  });
  visit_bonds(touched, group, [&](std::size_t row, int body, std::size_t pair) {
    const BondedPair& of = touched.bodies[body].bonds.pairs[pair];
    group.problem[row].free_velocity = world.nodes.velocities[of.first] - world.nodes.velocities[of.second];
  });
}

void hand_out_impulses(WorldState& world, TouchedBodies& touched, const ContactGroup& group) {
  for (std::size_t k = 0; k < group.contacts.size(); ++k)
    world.contact_world.set_impulse(group.contacts[k], group.problem[k].axes * group.problem[k].impulse);
  visit_bonds(touched, group, [&](std::size_t row, int body, std::size_t pair) {
    touched.bodies[body].bond_impulses[pair] = group.problem[row].impulse;
  });
}

/// Solves the problems of groups, and hands out what they find.
void solve_groups(WorldState& world, TouchedBodies& touched, std::span<ContactGroup* const> groups, double dt,
                  bool continues) {
  std::vector<ContactSolveReport> reports(groups.size());
  parallel_for(static_cast<int>(groups.size()), 1, [&](int begin, int end) {
    for (int i = begin; i < end; ++i) {
      ContactGroup& group = *groups[i];
      std::vector<NodeVectors> changes;
      ContactTolerance tolerance = tolerance_of(world, dt);
      tolerance.continues = continues;
      tolerance.relative = std::max(tolerance.relative, group.tolerance);
      reports[i] = solve_with_bonds(touched, group, tolerance, changes, dt);
      for (std::size_t k = 0; k < group.touched.size(); ++k)
        touched.bodies[group.touched[k]].change = std::move(changes[k]);
    }
  });
  for (std::size_t i = 0; i < groups.size(); ++i) {
    ContactGroup& group = *groups[i];
    hand_out_impulses(world, touched, group);
    world.report.unconverged_contacts += reports[i].unconverged - group.unconverged;
    group.unconverged = reports[i].unconverged;
    world.report.contact_iterations += reports[i].iterations;
  }
}

/// True if two contacts have one problem; their impulses are left out.
bool are_alike(const FrictionContact& left, const FrictionContact& right) {
  return left.a == right.a && left.b == right.b && left.axes == right.axes && left.friction == right.friction &&
         left.target_velocity == right.target_velocity && left.rebound == right.rebound &&
         left.free_velocity == right.free_velocity && left.hold == right.hold;
}

/// Takes the solution of an earlier group with the same problem of the same bodies. Returns false if there is none.
bool take_solution(WorldState& world, TouchedBodies& touched, ContactGroup& group, const SolvedContacts& earlier) {
  const auto bodies_of = [](const ContactGroup& of, const TouchedBodies& among) {
    std::vector<BodyId> bodies;
    for (const int i : of.touched) bodies.push_back(among.bodies[i].body);
    return bodies;
  };
  const std::vector<BodyId> bodies = bodies_of(group, touched);
  const auto found = std::ranges::find_if(earlier.groups, [&](const ContactGroup& other) {
    return other.rigid == group.rigid && std::ranges::equal(other.problem, group.problem, are_alike) &&
           bodies_of(other, earlier.touched) == bodies;
  });
  if (found == earlier.groups.end()) return false;
  for (std::size_t i = 0; i < group.touched.size(); ++i)
    touched.bodies[group.touched[i]].change = earlier.touched.bodies[found->touched[i]].change;
  group.problem = found->problem;
  group.unconverged = found->unconverged;
  world.report.unconverged_contacts += group.unconverged;
  hand_out_impulses(world, touched, group);
  return true;
}

}  // namespace

std::vector<ContactGroup> solve_elastic_contacts(WorldState& world, TouchedBodies& touched, double dt,
                                                 const SolvedContacts& earlier) {
  for (const ContactGroup& group : earlier.groups) world.report.unconverged_contacts -= group.unconverged;
  for (std::size_t i = 0; i < touched.bodies.size(); ++i)
    touched.objects[i].free_velocities = point_velocities(world, touched.bodies[i]);
  world.contact_world.solve(dt, coupled_objects(world, touched), hinged_objects(world, touched, dt));
  world.contact_world.leave_unsettled_groups(dt);
  std::vector<ContactGroup> groups;
  GroupBuilder builder(world, touched, dt);
  for (std::vector<int>& contacts : world.contact_world.elastic_groups()) {
    groups.push_back(builder.build(std::move(contacts)));
    foresee_turns(world, touched, dt, groups.back());
  }
  std::ranges::move(builder.build_bonded(), std::back_inserter(groups));
  std::vector<ContactGroup*> unsolved;
  for (ContactGroup& group : groups)
    if (!take_solution(world, touched, group, earlier)) unsolved.push_back(&group);
  solve_groups(world, touched, unsolved, dt, false);
  return groups;
}

void solve_again(WorldState& world, TouchedBodies& touched, std::span<ContactGroup* const> groups, double dt) {
  for (ContactGroup* group : groups) {
    renew(world, touched, dt, *group);
    foresee_turns(world, touched, dt, *group);
  }
  solve_groups(world, touched, groups, dt, true);
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
