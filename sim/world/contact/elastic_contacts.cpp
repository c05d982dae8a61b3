#include "sim/world/contact/elastic_contacts.h"

#include <algorithm>
#include <numeric>
#include <utility>

#include "sim/core/parallel.h"
#include "sim/solver/contact_problem.h"
#include "sim/world/bodies/bodies.h"
#include "sim/world/bodies/impact_speeds.h"
#include "sim/world/bodies/supported_motion.h"
#include "sim/world/contact/bond_rows.h"
#include "sim/world/motion/elastic_phase.h"
#include "sim/world/state/world_state.h"

namespace griffith {

namespace {

ContactTolerance tolerance_of(const WorldState& world, double dt) {
  constexpr double kNegligible = 1e-6;  // of what gravity adds in a substep
  ContactTolerance tolerance;
  tolerance.relative = std::min(1e-4, world.model->scene.simulation.relative_residual);
  tolerance.negligible_speed = std::max(1e-12, kNegligible * dt * world.model->scene.gravity.norm());
  tolerance.max_iterations = world.model->scene.simulation.max_solver_iterations;
  return tolerance;
}

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

/// True if the waves of an impact on a body end within a small part of a step, which damps them.
bool rebounds_by_law(const WorldState& world, const Body& body) {
  return !world.integrates_explicitly() && !is_thin(body) && !responds_slowly(world, body);
}

/// Returns the coupled bodies, with their indices in `touched`.
std::vector<ElasticObject> coupled_objects(const WorldState& world, const TouchedBodies& touched) {
  std::vector<ElasticObject> coupled;
  for (std::size_t i = 0; i < touched.bodies.size(); ++i) {
    const Body& body = world.bodies[touched.bodies[i].body];
    if (body.quasi_static) continue;
    coupled.push_back(touched.objects[i]);
    coupled.back().rebounds_by_law = rebounds_by_law(world, body);
  }
  return coupled;
}

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
  std::vector<ContactGroup> groups = build_contact_groups(world, touched, dt);
  for (ContactGroup& group : groups) foresee_turns(world, touched, dt, group);
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

}  // namespace griffith
