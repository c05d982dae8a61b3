#include "sim/world/contact/respond.h"

#include <algorithm>
#include <numeric>
#include <optional>
#include <utility>

#include "sim/core/parallel.h"
#include "sim/solver/contact_response.h"
#include "sim/world/bodies/surface_point.h"
#include "sim/world/contact/group_builder.h"
#include "sim/world/contact/pressure_distribution.h"
#include "sim/world/contact/quasi_static.h"
#include "sim/world/motion/elastic_phase.h"

namespace griffith {
namespace {

/// Returns the velocity changes of an elastic body's rows by nodal impulses, each node on its own; edges as solved.
NodeVectors respond_explicitly(WorldState& world, const TouchedBody& touched, double dt,
                               const std::vector<Vec3>& impulses) {
  const Body& body = world.bodies[touched.body];
  NodeArrays& nodes = world.nodes;
  NodeVectors change = body.system->gather(impulses);
  change.rightCols(body.system->edges().size()) = touched.change.rightCols(body.system->edges().size());
  const std::span<const NodeId> rows = body.system->nodes();
  for (std::size_t row = 0; row < rows.size(); ++row) {
    const NodeId node = rows[row];
    change.col(row) = (nodes.constraints[node].allowed * change.col(row) / nodes.masses[node]).eval();
  }
  for (NodeId node : body.system->supports())
    nodes.reactions[node] -= (impulses[node] - nodes.constraints[node].allowed * impulses[node]) / dt;
  return change;
}

/// Adds what its contacts did to the velocities of a body.
void add_changes(WorldState& world, const TouchedBody& touched) {
  const std::span<const NodeId> nodes = world.bodies[touched.body].system->nodes();
  for (std::size_t row = 0; row < nodes.size(); ++row) world.nodes.velocities[nodes[row]] += touched.change.col(row);
  const std::span<const EdgeId> edges = world.bodies[touched.body].system->edges();
  for (std::size_t i = 0, row = nodes.size(); i < edges.size(); ++i, ++row)
    world.edges.velocities[edges[i]] += touched.change.col(row);
}

/// Impulses on a body and where they act.
struct LoadedBody {
  TouchedBody at;
  Eigen::Matrix3Xd impulses;  ///< one column a point [N·s]
};

/// Adds a point with the impulse of its contact on an object.
void add_point(const Contact& contact, ProxyId object, const TouchedPoint& point, LoadedBody& loaded) {
  loaded.impulses.col(static_cast<Eigen::Index>(loaded.at.points.size())) =
      contact.a == object ? contact.impulse : Vec3(-contact.impulse);
  loaded.at.points.push_back(point);
}

/// Adds the impulses at the contacts of an object, except those that are replaced.
void add_impulses(std::span<const Contact> contacts, const std::vector<bool>& replaced, const TouchedBody& touched,
                  const ElasticObject& object, LoadedBody& loaded) {
  for (std::size_t k = 0; k < object.contacts.size(); ++k) {
    const int contact = object.contacts[k];
    if (!replaced[contact]) add_point(contacts[contact], object.object, touched.points[k], loaded);
  }
}

/// Adds the impulses at nodes of an object.
void add_spread_impulses(const WorldState& world, const std::vector<Contact>& spread, ProxyId object,
                         LoadedBody& loaded) {
  std::optional<SurfaceSearch> surface;
  for (const Contact& contact : spread) {
    if (contact.a != object && contact.b != object) continue;
    const NodeId node = contact.a == object ? contact.node_a : contact.node_b;
    if (!node.valid() && !surface) surface.emplace(world, world.bodies[loaded.at.body]);
    const TouchedPoint point =
        node.valid() ? touched_node(world, node, contact.position) : touched_point(world, *surface, contact.position);
    add_point(contact, object, point, loaded);
  }
}

LoadedBody loads_on(const WorldState& world, const TouchedBody& touched, const ElasticObject& object,
                    const SpreadContacts& spread) {
  const std::span<const Contact> contacts = world.contact_world.contacts();
  LoadedBody loaded;
  loaded.at.body = touched.body;
  loaded.impulses.resize(3, static_cast<Eigen::Index>(object.contacts.size() + spread.added.size()));
  add_impulses(contacts, spread.replaced, touched, object, loaded);
  if (world.bodies[touched.body].quasi_static) add_spread_impulses(world, spread.added, object.object, loaded);
  loaded.impulses.conservativeResize(Eigen::NoChange, static_cast<Eigen::Index>(loaded.at.points.size()));
  return loaded;
}

bool is_zero(const std::vector<Vec3>& impulses) {
  return std::ranges::all_of(impulses, [](const Vec3& impulse) { return impulse.isZero(0); });
}

void add_bond_impulses(const TouchedBody& touched, std::vector<Vec3>& nodal) {
  for (std::size_t i = 0; i < touched.bond_impulses.size(); ++i) {
    nodal[touched.bonds.pairs[i].first] += touched.bond_impulses[i];
    nodal[touched.bonds.pairs[i].second] -= touched.bond_impulses[i];
  }
}

double work_of_bonds(const WorldState& world, const TouchedBody& touched) {
  const std::vector<Vec3>& velocities = world.nodes.velocities;
  double work = 0;
  for (std::size_t i = 0; i < touched.bond_impulses.size(); ++i) {
    const BondedPair& pair = touched.bonds.pairs[i];
    work += touched.bond_impulses[i].dot(velocities[pair.first] - velocities[pair.second]);
  }
  return work;
}

/// Moves a body by the impulses at its contacts and of its bonds.
void respond(WorldState& world, TouchedBody& touched, const LoadedBody& loaded, double dt) {
  Body& body = world.bodies[touched.body];
  if (loaded.impulses.isZero(0) && is_zero(touched.bond_impulses) && touched.bonds.ties.empty()) return;
  std::vector<Vec3>& nodal = world.scratch.contact_impulses;
  add_nodal_impulses(world, loaded.at, loaded.impulses, nodal);
  add_bond_impulses(touched, nodal);
  if (body.quasi_static) {
    const ImplicitStep step = implicit_step(world, body, dt);
    touched.change = respond_alone(deformable_inertia(world, body, dt), body.system->gather(nodal),
                                   step.relative_residual, step.max_iterations);
  }
  if (world.integrates_explicitly()) {
    touched.change = respond_explicitly(world, touched, dt, nodal);
  } else {
    body.system->project(touched.change);
    body.system->add_reactions(dt, nodal, world.nodes.constraints, touched.change, world.nodes.reactions);
  }
  add_changes(world, touched);
  world.scratch.bodies[body.id].contact_work =
      loaded.impulses.cwiseProduct(point_velocities(world, loaded.at)).sum() + work_of_bonds(world, touched);
}

}  // namespace

void respond(WorldState& world, TouchedBodies& touched, std::span<const int> bodies, double dt) {
  for (const int i : bodies) {
    const Body& body = world.bodies[touched.bodies[i].body];
    for (const NodeId node : body.nodes) world.scratch.contact_impulses[node].setZero();
    world.scratch.bodies[body.id].contact_work = 0;
  }
  const bool spreads =
      std::ranges::any_of(bodies, [&](int i) { return world.bodies[touched.bodies[i].body].quasi_static; });
  const std::size_t contacts = std::as_const(world.contact_world).contacts().size();
  const SpreadContacts spread =
      spreads ? spread_impulses(world) : SpreadContacts{std::vector<bool>(contacts, false), {}};
  parallel_for(static_cast<int>(bodies.size()), 1, [&](int begin, int end) {
    for (const int i : bodies.subspan(begin, end - begin))
      respond(world, touched.bodies[i], loads_on(world, touched.bodies[i], touched.objects[i], spread), dt);
  });
  if (spreads) limit_deformation(world, touched, bodies);
}

void respond(WorldState& world, TouchedBodies& touched, double dt) {
  world.scratch.contact_impulses.assign(world.nodes.positions.size(), Vec3::Zero());
  std::vector<int> all(touched.bodies.size());
  std::iota(all.begin(), all.end(), 0);
  respond(world, touched, all, dt);
}

}  // namespace griffith
