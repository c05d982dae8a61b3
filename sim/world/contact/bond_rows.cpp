#include "sim/world/contact/bond_rows.h"

#include <algorithm>
#include <limits>
#include <span>

namespace griffith {
namespace {

/// Side of a bond or of a tie: a single row of a body's system.
ContactSide row_side(int body, int row, const Mat3& allowed) {
  ContactSide side;
  side.body = body;
  side.deformable = true;
  side.point = {{row, -1, -1}, {allowed, Mat3::Zero(), Mat3::Zero()}};
  return side;
}

ContactSide node_side(const WorldState& world, int body, NodeId node) {
  return row_side(body, world.nodes.rows[node], world.nodes.constraints[node].allowed);
}

ContactSide edge_side(const WorldState& world, int body, EdgeId edge) {
  const auto& [a, b] = world.tet_edges->ends[edge];
  const std::vector<NodeConstraint>& constraints = world.nodes.constraints;
  return row_side(body, world.edges.rows[edge], constraint_between(constraints[a], constraints[b]).allowed);
}

void add_row(const ContactSide& first, const ContactSide& second, const Vec3& velocity, const Hold& hold,
             ContactGroup& group) {
  FrictionContact& row = group.problem.emplace_back();
  row.a = first, row.b = second;
  row.free_velocity = velocity;
  row.hold = hold;
  group.target_velocities.push_back(0);
}

}  // namespace

void add_bond_rows(const WorldState& world, const TouchedBody& of, int body, double dt, ContactGroup& group) {
  const NodeArrays& nodes = world.nodes;
  for (const BondedPair& pair : of.bonds.pairs)
    add_row(node_side(world, body, pair.first), node_side(world, body, pair.second),
            nodes.velocities[pair.first] - nodes.velocities[pair.second],
            {(nodes.positions[pair.first] - nodes.positions[pair.second]) / dt, pair.opening / dt,
             dt * pair.force_up_to(pair.opening)},
            group);
  for (const TiedEdges& tied : of.bonds.ties)
    add_row(edge_side(world, body, tied.first), edge_side(world, body, tied.second),
            world.edges.velocities[tied.first] - world.edges.velocities[tied.second],
            {Vec3::Zero(), 0, std::numeric_limits<double>::infinity()}, group);
}

namespace {

/// Weakens bonds that open under the impulses found: over all of their way they take the energy of their law. Their
/// strength only falls, so that they open no farther than they must. Returns true if any changes notably.
bool weaken_bonds(const TouchedBodies& touched, ContactGroup& group, double dt) {
  constexpr double kNotable = 1e-2;
  bool changed = false;
  visit_bonds(touched, group, [&](std::size_t row, int body, std::size_t pair) {
    FrictionContact& bond = group.problem[row];
    const double opening = dt * (bond.hold->apart + bond.velocity).norm();
    const double strength = dt * touched.bodies[body].bonds.pairs[pair].force_up_to(opening);
    changed |= strength < (1 - kNotable) * bond.hold->strength;
    bond.hold->strength = std::min(bond.hold->strength, strength);
  });
  return changed;
}

/// True if the response of bodies away from contacts is work of its own.
bool any_condensed(const ContactSystem& system) {
  for (std::size_t i = 0; i < system.deformable.size(); ++i)
    if (system.bodies.condensed(i)) return true;
  return false;
}

}  // namespace

ContactSolveReport solve_with_bonds(const TouchedBodies& touched, ContactGroup& group,
                                    const ContactTolerance& tolerance, std::vector<NodeVectors>& changes, double dt) {
  constexpr int kMostOpenings = 40;
  ContactSystem system(group.deformable, group.rigid, group.problem);
  ContactTolerance now = tolerance;
  now.contacts_alone = group.problem.size() > group.contacts.size() && any_condensed(system);
  ContactSolveReport report;
  for (int opening = 1; opening <= kMostOpenings; ++opening) {
    const ContactSolveReport found = solve_contact_problem(system, group.problem, now, changes);
    report.iterations += found.iterations;
    report.unconverged = found.unconverged;
    const bool opens = weaken_bonds(touched, group, dt);
    if (!opens && !now.contacts_alone) break;
    now.contacts_alone = now.contacts_alone && opens && opening < kMostOpenings - 1;
    now.continues = true;
  }
  return report;
}

}  // namespace griffith
